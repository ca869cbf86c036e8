#include "core/vessel/Machinery.h"

#include "core/base/Units.h"
#include "core/vessel/ReadPoint.h"

namespace sagara::core {
namespace {

constexpr std::array<const char*, kTelegraphSteps> kStepNames{"fullAstern",     "halfAstern", "slowAstern",
                                                              "deadSlowAstern", "stop",       "deadSlowAhead",
                                                              "slowAhead",      "halfAhead",  "fullAhead"};

PropulsionUnit readUnit(const config::Node& node) {
    config::Reader in(node);
    PropulsionUnit u;
    u.id = in.text("id");
    u.position = readBodyPoint(in);
    u.diameter_m = in.number("diameter_m", {0.1, 15.0, "m"});
    const std::vector<double> kt = in.numbers("thrustCoefficients", 3, {-2.0, 2.0, ""});
    u.thrustCoefficients = {kt[0], kt[1], kt[2]};
    u.wakeFraction = in.number("wakeFraction", {-0.3, 0.7, ""});
    u.thrustDeduction = in.number("thrustDeduction", {-0.1, 0.5, ""});
    u.asternThrustRatio = in.number("asternThrustRatio", {0.2, 1.0, ""});
    u.shaftRate_rpsps = kRpm_rps * in.number("shaftRate_rpmps", {0.1, 1000.0, "rpm/s"});
    u.reversingTime_s = in.number("reversingTime_s", {0.0, 120.0, "s"});
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
    if (in.has("rudders") && s.rudders.empty()) in.problem("rudders", "is empty", "at least one rudder");
    s.areaEach_m2 = in.number("areaEach_m2", {0.05, 200.0, "m2"});
    s.liftSlope_perRad = in.number("liftSlope_perDeg", {0.005, 0.2, "1/deg"}) / kDegree_rad;
    s.stallAngle_rad = kDegree_rad * in.number("stallAngle_deg", {5.0, 70.0, "deg"});
    s.limit_rad = kDegree_rad * in.number("limit_deg", {10.0, 70.0, "deg"});
    s.rate_radps = kDegree_rad * in.number("rate_degps", {0.5, 20.0, "deg/s"});
    s.lag_s = in.number("lag_s", {0.0, 5.0, "s"});
    s.raceShare = in.number("raceShare", {0.0, 1.5, ""});
    s.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
