#include "core/vessel/Machinery.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/ReadPoint.h"

namespace sagara::core {
namespace {

constexpr std::array<const char*, kTelegraphSteps> kStepNames{"fullAstern",     "halfAstern", "slowAstern",
                                                              "deadSlowAstern", "stop",       "deadSlowAhead",
                                                              "slowAhead",      "halfAhead",  "fullAhead"};

PitchControl readPitch(const config::Node& node) {
    config::Reader in(node);
    PitchControl p;
    p.least = in.number("least", {-1.2, 0.0, ""});
    p.most = in.number("most", {0.3, 1.5, ""});
    p.rate_perS = in.number("rate_perS", {0.005, 1.0, "1/s"});
    p.slowest_rps = kRpm_rps * in.number("slowest_rpm", {0.0, 2000.0, "rpm"});
    in.rejectUnknownKeys();
    return p;
}

AzimuthDrive readAzimuth(const config::Node& node) {
    config::Reader in(node);
    const AzimuthDrive a{kDegree_rad * in.number("rate_degps", {1.0, 60.0, "deg/s"})};
    in.rejectUnknownKeys();
    return a;
}

/// Of shaft, propeller, its water and engine, where nobody measured it: 8 D^5 in SI, as bronze propellers
/// with a quarter for their water and as much again for a slow engine come to.
double usualInertia_kgm2(double diameter_m) { return 8.0 * std::pow(diameter_m, 5); }

Engine readEngine(const config::Node& node, double diameter_m) {
    config::Reader in(node);
    Engine e;
    const double power_W = 1e3 * in.number("power_kW", {5.0, 1.2e5, "kW"});
    e.full_rps = kRpm_rps * in.number("speed_rpm", {30.0, 3000.0, "rpm"});
    e.torque_Nm = power_W / (kTwoPi * e.full_rps);
    e.idle_rps = kRpm_rps * in.number("idle_rpm", {0.0, 1000.0, "rpm"});
    if (in.sound() && e.idle_rps >= e.full_rps)
        in.problem("idle_rpm", "is " + config::formatNumber(e.idle_rps / kRpm_rps), "less than speed_rpm");
    e.inertia_kgm2 = in.numberOr("inertia_kgm2", usualInertia_kgm2(diameter_m), {0.01, 1e7, "kg m2"});
    if (in.has("startAir")) {
        config::Reader air(in.child("startAir"));
        e.startAir =
            StartAir{air.number("starts", {1.0, 100.0, ""}), air.number("refill_s", {1.0, 7200.0, "s"})};
        air.rejectUnknownKeys();
    }
    in.rejectUnknownKeys();
    return e;
}

/// Either KT ahead alone, or a propeller known in all quadrants.
void readCharacteristics(config::Reader& in, PropulsionUnit& u) {
    const bool whole = in.has("wageningenB");
    std::vector<double> kt;
    if (!whole || in.has("thrustCoefficients")) {
        kt = in.numbers("thrustCoefficients", whole ? 0 : 3, {-2.0, 2.0, ""});
    }
    if (whole) {
        u.openWater = readOpenWater(in, std::move(kt));
        return;
    }
    u.thrustCoefficients = {kt[0], kt[1], kt[2]};
    u.asternThrustRatio = in.number("asternThrustRatio", {0.2, 1.0, ""});
}

PropulsionUnit readUnit(const config::Node& node) {
    config::Reader in(node);
    PropulsionUnit u;
    u.id = in.text("id");
    u.position = readBodyPoint(in);
    u.diameter_m = in.number("diameter_m", {0.1, 15.0, "m"});
    readCharacteristics(in, u);
    u.wakeFraction = in.number("wakeFraction", {-0.3, 0.7, ""});
    u.thrustDeduction = in.number("thrustDeduction", {-0.1, 0.5, ""});
    u.shaftRate_rpsps = kRpm_rps * in.number("shaftRate_rpmps", {0.1, 1000.0, "rpm/s"});
    u.reversingTime_s = in.number("reversingTime_s", {0.0, 120.0, "s"});
    if (in.has("pitch")) u.pitch = readPitch(in.child("pitch"));
    if (in.has("azimuth")) u.azimuth = readAzimuth(in.child("azimuth"));
    if (in.has("engine")) u.engine = readEngine(in.child("engine"), u.diameter_m);
    if ((u.engine || u.pitch) && !u.openWater)
        in.problem(u.engine ? "engine" : "pitch", "goes with a propeller of known torque",
                   "\"wageningenB\" with blades, areaRatio and pitchRatio");
    in.rejectUnknownKeys();
    return u;
}

TelegraphTable readTelegraph(config::Reader& propulsion) {
    config::Reader in(propulsion.child("telegraph_rpm"));
    TelegraphTable table{};
    for (std::size_t i = 0; i < kTelegraphSteps; ++i) {
        if (i != static_cast<std::size_t>(TelegraphStep::Stop)) {
            table[i] = kRpm_rps * in.number(kStepNames[i], {-3000.0, 3000.0, "rpm"});
        }
        if (i > 0 && in.has(kStepNames[i]) && table[i] <= table[i - 1]) {
            in.problem(
                kStepNames[i], "is " + config::formatNumber(table[i] / kRpm_rps),
                "more than the step below it, " + config::formatNumber(table[i - 1] / kRpm_rps) + " rpm");
        }
    }
    in.rejectUnknownKeys();
    return table;
}

}  // namespace

const char* telegraphStepName(TelegraphStep step) { return kStepNames[static_cast<std::size_t>(step)]; }

Propulsion readPropulsion(config::Reader& in) {
    Propulsion p;
    for (const config::Node& node : in.list("units")) p.units.push_back(readUnit(node));
    if (in.has("units") && (p.units.empty() || p.units.size() > 4)) {
        in.problem("units", "has " + std::to_string(p.units.size()) + " units", "1 to 4");
    }
    p.telegraph_rps = readTelegraph(in);
    p.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return p;
}

Steering readSteering(config::Reader& in) {
    Steering s;
    for (const config::Node& node : in.list("rudders")) {
        config::Reader rudder(node);
        s.rudders.push_back(readBodyPoint(rudder));
        rudder.rejectUnknownKeys();
    }
    if (!s.rudders.empty() || in.has("areaEach_m2")) {
        s.areaEach_m2 = in.number("areaEach_m2", {0.05, 200.0, "m2"});
        s.liftSlope_perRad = in.number("liftSlope_perDeg", {0.005, 0.2, "1/deg"}) / kDegree_rad;
        s.stallAngle_rad = kDegree_rad * in.number("stallAngle_deg", {5.0, 70.0, "deg"});
        s.raceShare = in.number("raceShare", {0.0, 1.5, ""});
    }
    s.limit_rad = kDegree_rad * in.number("limit_deg", {10.0, 70.0, "deg"});
    s.rate_radps = kDegree_rad * in.number("rate_degps", {0.5, 20.0, "deg/s"});
    s.lag_s = in.number("lag_s", {0.0, 5.0, "s"});
    s.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
