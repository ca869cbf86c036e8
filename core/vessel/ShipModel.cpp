#include "core/vessel/ShipModel.h"

#include <sstream>

namespace sagara::core {
namespace {

using Factor = PolynomialTerm::Factor;

constexpr double kAny = 1e15;

struct NamedFactor {
    const char* name;
    Factor factor;
};
constexpr NamedFactor kFactors[] = {
    {"u", Factor::Surge},       {"v", Factor::Sway},         {"r", Factor::YawRate},
    {"p", Factor::RollRate},    {"phi", Factor::Roll},       {"|u|", Factor::AbsSurge},
    {"|v|", Factor::AbsSway},   {"|r|", Factor::AbsYawRate}, {"|p|", Factor::AbsRollRate},
    {"|phi|", Factor::AbsRoll},
};

bool findFactor(const std::string& name, Factor& factor) {
    for (const NamedFactor& f : kFactors) {
        if (name == f.name) {
            factor = f.factor;
            return true;
        }
    }
    return false;
}

PolynomialTerm readTerm(const config::Node& node) {
    config::Reader in(node);
    PolynomialTerm term;
    const std::string of = in.text("of");
    if (!of.empty() && !parseFactors(of, term.factors)) {
        in.problem("of", "is \"" + of + "\"",
                   "up to four of u v r p phi |u| |v| |r| |p| |phi|, such as \"phi |u| v\" or \"r^2\"");
    }
    const config::Range any{-kAny, kAny, "SI"};
    term.surge = in.numberOr("X", 0.0, any);
    term.sway = in.numberOr("Y", 0.0, any);
    term.roll = in.numberOr("K", 0.0, any);
    term.yaw = in.numberOr("N", 0.0, any);
    term.crossFlow = in.flagOr("crossFlow", false);
    term.turnsAstern = in.flagOr("turnsAstern", false);
    in.rejectUnknownKeys();
    return term;
}

void readRigidBody(PolynomialModel& m, const config::Node& node) {
    config::Reader in(node);
    m.mass_kg = in.number("mass_kg", {100.0, 1e9, "kg"});
    m.xG_m = in.number("xG_m", {-100.0, 100.0, "m"});
    m.zG_m = in.number("zG_m", {-50.0, 50.0, "m"});
    m.rollInertia_kgm2 = in.number("Ixx_kgm2", {1.0, kAny, "kg m2"});
    m.yawInertia_kgm2 = in.number("Izz_kgm2", {1.0, kAny, "kg m2"});
    in.rejectUnknownKeys();
}

void readAddedMass(PolynomialModel& m, const config::Node& node) {
    config::Reader in(node);
    const config::Range resisting{-kAny, 0.0, "SI"}, any{-kAny, kAny, "SI"};
    m.Xudot = in.number("Xudot", resisting);
    m.Yvdot = in.number("Yvdot", resisting);
    m.Ypdot = in.numberOr("Ypdot", 0.0, any);
    m.Yrdot = in.numberOr("Yrdot", 0.0, any);
    m.Kvdot = in.numberOr("Kvdot", 0.0, any);
    m.Kpdot = in.number("Kpdot", resisting);
    m.Krdot = in.numberOr("Krdot", 0.0, any);
    m.Nvdot = in.numberOr("Nvdot", 0.0, any);
    m.Npdot = in.numberOr("Npdot", 0.0, any);
    m.Nrdot = in.number("Nrdot", resisting);
    in.rejectUnknownKeys();
}

PolynomialModel readPolynomial(config::Reader& in) {
    PolynomialModel m;
    readRigidBody(m, in.child("rigidBody"));
    readAddedMass(m, in.child("addedMass"));
    for (const config::Node& node : in.list("terms")) m.terms.push_back(readTerm(node));
    config::Reader published(in.child("published"));
    m.rudderYawLever_m = published.number("rudderYawLever_m", {0.0, 250.0, "m"});
    m.rudderRollLever_m = published.number("rudderRollLever_m", {-10.0, 30.0, "m"});
    m.publishedThrust_N = published.number("thrust_N", {1.0, 1e8, "N"});
    m.publishedShaft_rps = published.number("atShaft_rps", {0.1, 50.0, "1/s"});
    m.holdsFrom_mps = published.number("holdsFrom_mps", {0.0, 30.0, "m/s"});
    m.holdsTo_mps = published.number("holdsTo_mps", {0.5, 40.0, "m/s"});
    published.rejectUnknownKeys();
    config::Reader extension(in.child("lowSpeedExtension"));
    m.extensionBelow_mps = extension.number("wholeBelow_mps", {0.0, 30.0, "m/s"});
    m.crossFlowDrag = extension.number("crossFlowDrag", {0.0, 3.0, ""});
    if (m.extensionBelow_mps >= m.holdsFrom_mps) {
        extension.problem(
            "wholeBelow_mps", "is " + config::formatNumber(m.extensionBelow_mps),
            "less than published.holdsFrom_mps, " + config::formatNumber(m.holdsFrom_mps) + " m/s");
    }
    extension.text("source");
    extension.rejectUnknownKeys();
    return m;
}

SandaruwanModel readSandaruwan(config::Reader& in) {
    SandaruwanModel m;
    m.gain_perS = in.number("gain_perS", {1e-5, 2.0, "1/s"});
    m.timeConstant_s = in.number("timeConstant_s", {0.5, 2000.0, "s"});
    m.swayGain_m = in.number("swayGain_m", {-400.0, 0.0, "m"});
    m.swayTimeConstant_s = in.number("swayTimeConstant_s", {0.1, 1000.0, "s"});
    m.referenceSpeed_mps = in.number("referenceSpeed_mps", {0.5, 30.0, "m/s"});
    m.scalesWithSpeed = in.flagOr("scalesWithSpeed", true);
    m.surgeAddedMassRatio = in.number("surgeAddedMassRatio", {0.0, 0.5, ""});
    m.resistance_kgpm = in.number("resistance_kgpm", {1.0, 1e7, "kg/m"});
    m.surgeFromTurn_kg = in.number("surgeFromTurn_kg", {0.0, 1e9, "kg"});
    m.swayAddedMassRatio = in.number("swayAddedMassRatio", {0.1, 3.0, ""});
    m.yawAddedInertiaRatio = in.number("yawAddedInertiaRatio", {0.1, 3.0, ""});
    m.crossFlowDrag = in.number("crossFlowDrag", {0.0, 3.0, ""});
    return m;
}

template <auto read>
ShipModel readAs(config::Reader& in) {
    return read(in);
}

}  // namespace

bool parseFactors(const std::string& text, std::array<Factor, 4>& factors) {
    factors = {};
    std::size_t count = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::size_t times = 1;
        if (word.size() > 2 && word[word.size() - 2] == '^') {
            const char digit = word.back();
            if (digit < '2' || digit > '4') return false;
            times = static_cast<std::size_t>(digit - '0');
            word.resize(word.size() - 2);
        }
        Factor factor{};
        if (!findFactor(word, factor)) return false;
        for (std::size_t i = 0; i < times; ++i) {
            if (count == factors.size()) return false;
            factors[count++] = factor;
        }
    }
    return count > 0;
}

NamedModel readShipModel(config::Reader& in) {
    using Read = ShipModel (*)(config::Reader&);
    const auto read = in.choiceIfKnown<Read>("kind", {{"polynomial", readAs<readPolynomial>},
                                                      {"sandaruwan2010", readAs<readSandaruwan>},
                                                      {"mmg", readAs<readMmg>}});
    const std::string name = in.has("name") ? in.id("name") : in.textOr("kind", "");
    const Provenance provenance = readProvenance(in);
    if (!read) return {name, provenance, {}};
    NamedModel model{name, provenance, (*read)(in)};
    in.rejectUnknownKeys();
    return model;
}

Seakeeping readSeakeeping(config::Reader& in) {
    Seakeeping s;
    const config::Range ratio{0.0, 5.0, ""}, damping{0.005, 1.5, ""};
    s.heaveAddedMassRatio = in.number("heaveAddedMassRatio", ratio);
    s.heaveDampingRatio = in.number("heaveDampingRatio", damping);
    s.pitchAddedInertiaRatio = in.number("pitchAddedInertiaRatio", ratio);
    s.pitchDampingRatio = in.number("pitchDampingRatio", damping);
    s.rollAddedInertiaRatio = in.number("rollAddedInertiaRatio", ratio);
    s.rollDampingRatio = in.number("rollDampingRatio", damping);
    s.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
