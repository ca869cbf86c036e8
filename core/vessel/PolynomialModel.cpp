#include "core/vessel/PolynomialModel.h"

namespace sagara::core {
namespace {

constexpr double kAny = 1e15;
constexpr config::Range kNumber{-kAny, kAny, ""};

PolynomialTerm readTerm(const config::Node& node) {
    config::Reader in(node);
    PolynomialTerm term;
    const std::string of = in.text("of");
    if (!of.empty() && !parseFactors(of, term.factors)) {
        in.problem("of", "is \"" + of + "\"",
                   "up to six of 1 u v r p phi delta c n z atan(v/u) and their absolute values, such as "
                   "\"phi |u| v\" or \"r^2\"");
    }
    term.surge = in.numberOr("X", 0.0, kNumber);
    term.sway = in.numberOr("Y", 0.0, kNumber);
    term.roll = in.numberOr("K", 0.0, kNumber);
    term.yaw = in.numberOr("N", 0.0, kNumber);
    term.crossFlow = in.flagOr("crossFlow", false);
    term.turnsAstern = in.flagOr("turnsAstern", false);
    term.fromDepth = in.numberOr("fromDepthParameter", 0.0, {0.0, 20.0, ""});
    in.rejectUnknownKeys();
    return term;
}

PolynomialScale readScale(const config::Node& node) {
    using By = PolynomialScale::By;
    config::Reader in(node);
    PolynomialScale s;
    s.by = in.choice<By>("by", {{"prime", By::Prime}, {"prime at U0", By::PrimeReference}, {"bis", By::Bis}});
    s.length_m = in.number("length_m", {1.0, 500.0, "m"});
    s.perturbation = in.flagOr("surgeIsPerturbation", false);
    if (s.perturbation || s.by == By::PrimeReference)
        s.referenceSpeed_mps = in.number("referenceSpeed_mps", {0.1, 40.0, "m/s"});
    s.rudderSign =
        in.choice<double>("rudderPositive", {{"turns to starboard", 1.0}, {"turns to port", -1.0}});
    in.rejectUnknownKeys();
    return s;
}

/// Names of SI members carry their unit.
void readRigidBody(PolynomialModel& m, const config::Node& node, bool si) {
    config::Reader in(node);
    m.mass = in.number(si ? "mass_kg" : "mass", {si ? 100.0 : 1e-6, 1e9, si ? "kg" : ""});
    m.xG = in.number(si ? "xG_m" : "xG", {-100.0, 100.0, si ? "m" : ""});
    const char *zG = si ? "zG_m" : "zG", *Ixx = si ? "Ixx_kgm2" : "Ixx", *Izz = si ? "Izz_kgm2" : "Izz";
    const config::Range inertia{si ? 1.0 : 1e-9, kAny, si ? "kg m2" : ""};
    if (si || in.has(Ixx)) {
        m.zG = in.number(zG, {-50.0, 50.0, si ? "m" : ""});
        m.Ixx = in.number(Ixx, inertia);
    }
    m.Izz = in.number(Izz, inertia);
    in.rejectUnknownKeys();
}

void readAddedMass(PolynomialModel& m, const config::Node& node) {
    config::Reader in(node);
    const config::Range resisting{-kAny, 0.0, ""};
    m.Xudot = in.number("Xudot", resisting);
    m.Yvdot = in.number("Yvdot", resisting);
    m.Yrdot = in.numberOr("Yrdot", 0.0, kNumber);
    m.Nvdot = in.numberOr("Nvdot", 0.0, kNumber);
    m.Nrdot = in.number("Nrdot", resisting);
    if (m.Ixx) {
        m.Ypdot = in.numberOr("Ypdot", 0.0, kNumber);
        m.Kvdot = in.numberOr("Kvdot", 0.0, kNumber);
        m.Kpdot = in.number("Kpdot", resisting);
        m.Krdot = in.numberOr("Krdot", 0.0, kNumber);
        m.Npdot = in.numberOr("Npdot", 0.0, kNumber);
    }
    in.rejectUnknownKeys();
}

void readDepth(PolynomialModel& m, const config::Node& node) {
    config::Reader in(node);
    m.draught_m = in.number("draught_m", {0.2, 30.0, "m"});
    m.leastDepthRatio = in.number("leastRatio", {1.05, 3.0, ""});
    const config::Range resisting{-kAny, 0.0, ""};
    m.XudotDepth = in.numberOr("Xudot", 0.0, resisting);
    m.YvdotDepth = in.numberOr("Yvdot", 0.0, resisting);
    m.NrdotDepth = in.numberOr("Nrdot", 0.0, resisting);
    in.rejectUnknownKeys();
}

LiftDrive readLift(config::Reader& model) {
    LiftDrive d;
    config::Reader published(model.child("published"));
    d.rudderYawLever_m = published.number("rudderYawLever_m", {0.0, 250.0, "m"});
    d.rudderRollLever_m = published.number("rudderRollLever_m", {-10.0, 30.0, "m"});
    d.thrust_N = published.number("thrust_N", {1.0, 1e8, "N"});
    d.shaft_rps = published.number("atShaft_rps", {0.1, 50.0, "1/s"});
    d.holdsFrom_mps = published.number("holdsFrom_mps", {0.0, 30.0, "m/s"});
    d.holdsTo_mps = published.number("holdsTo_mps", {0.5, 40.0, "m/s"});
    published.rejectUnknownKeys();
    config::Reader extension(model.child("lowSpeedExtension"));
    d.extensionBelow_mps = extension.number("wholeBelow_mps", {0.0, 30.0, "m/s"});
    d.crossFlowDrag = extension.number("crossFlowDrag", {0.0, 3.0, ""});
    if (d.extensionBelow_mps >= d.holdsFrom_mps) {
        extension.problem(
            "wholeBelow_mps", "is " + config::formatNumber(d.extensionBelow_mps),
            "less than published.holdsFrom_mps, " + config::formatNumber(d.holdsFrom_mps) + " m/s");
    }
    extension.text("source");
    extension.rejectUnknownKeys();
    return d;
}

RaceDrive readRace(const config::Node& node) {
    config::Reader in(node);
    const config::Range small{-10.0, 10.0, ""};
    RaceDrive d;
    d.diameter_m = in.number("diameter_m", {0.1, 15.0, "m"});
    const std::vector<double> kt = in.numbers("KT", 3, {-2.0, 2.0, ""});
    d.thrustCoefficients = {kt[0], kt[1], kt[2]};
    d.t = in.number("t", {-0.1, 0.5, ""});
    d.wp = in.number("wp", {-0.3, 0.7, ""});
    d.tau = in.number("tau", small);
    d.xp = in.number("xp", {-1.0, 0.0, ""});
    d.cpv = in.number("cpv", small);
    d.cpr = in.number("cpr", small);
    d.area_m2 = in.number("area_m2", {0.05, 400.0, "m2"});
    d.aspect = in.number("aspect", {0.3, 10.0, ""});
    d.eps = in.number("eps", {0.1, 3.0, ""});
    d.kk = in.number("kk", {0.0, 3.0, ""});
    d.ga = in.number("ga", small);
    d.cRr = in.number("cRr", small);
    d.cRrrr = in.number("cRrrr", small);
    d.cRrrv = in.number("cRrrv", small);
    d.cRX = in.number("cRX", {0.0, 2.0, ""});
    d.aH = in.number("aH", {0.0, 2.0, ""});
    d.xR = in.number("xR", {-1.0, 0.0, ""});
    d.xH = in.number("xH", {-1.0, 0.0, ""});
    d.zR = in.number("zR", {-0.5, 0.5, ""});
    in.rejectUnknownKeys();
    return d;
}

void readInflow(PolynomialModel& m, const config::Node& node) {
    config::Reader in(node);
    m.inflow_m = in.number("un_m", {0.0, 100.0, "m"});
    m.inflow_m2 = in.number("nn_m2", {0.0, 1000.0, "m2"});
    in.rejectUnknownKeys();
}

}  // namespace

PolynomialModel readPolynomial(config::Reader& in) {
    PolynomialModel m;
    const bool si = !in.has("scale");
    if (!si) m.scale = readScale(in.child("scale"));
    m.turningInTerms = in.flagOr("turningInTerms", !si);
    readRigidBody(m, in.child("rigidBody"), si);
    readAddedMass(m, in.child("addedMass"));
    if (in.has("depth")) readDepth(m, in.child("depth"));
    if (in.has("inflow")) readInflow(m, in.child("inflow"));
    for (const config::Node& node : in.list("terms")) m.terms.push_back(readTerm(node));
    if (in.has("race")) m.race = readRace(in.child("race"));
    if (in.has("balancedAtShaft_rps")) m.balanced = {in.number("balancedAtShaft_rps", {0.1, 50.0, "1/s"})};
    if (si || in.has("published")) m.lift = readLift(in);
    return m;
}

}  // namespace sagara::core
