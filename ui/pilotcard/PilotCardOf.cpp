#include "ui/pilotcard/PilotCardOf.h"

#include <QString>
#include <cmath>

#include "core/base/Units.h"
#include "core/bridge/ShaftControl.h"
#include "core/identify/TrialShip.h"

namespace sagara::ui {
namespace {

using report::PilotCardData;

std::string shown(double value, int decimals, const char* unit = "") {
    std::string text = QString::number(value, 'f', decimals).toStdString();
    return *unit ? text.append(" ").append(unit) : text;
}

/// "deadSlowAhead" as "Dead slow ahead".
std::string wordsOf(const std::string& step) {
    std::string text;
    for (const char c : step) {
        if (c >= 'A' && c <= 'Z') {
            text += ' ';
            text += static_cast<char>(c - 'A' + 'a');
        } else {
            text += c;
        }
    }
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

void fillParticulars(PilotCardData& card, const core::Vessel& v) {
    const core::Hull& h = v.hull;
    card.particulars = {{"Length overall", shown(h.lengthOverall_m, 1, "m")},
                        {"Between perpendiculars", shown(h.lengthBp_m, 1, "m")},
                        {"Breadth", shown(h.beam_m, 2, "m")},
                        {"Draught", shown(h.draught_m, 2, "m, even keel")},
                        {"Displacement", shown(h.mass_kg() / 1000.0, 0, "t")},
                        {"Block coefficient", shown(h.blockCoefficient(), 3)},
                        {"Metacentric height", shown(h.metacentricHeight_m, 2, "m")},
                        {"Eye height on the bridge", shown(v.bridgeEyeHeight_m, 1, "m")},
                        {"Bridge to bow", shown(0.5 * h.lengthOverall_m - v.bridgeEye.x_m, 1, "m")}};
    for (const core::AnchorGear& a : v.groundTackle.anchors)
        card.anchors.push_back({a.id, shown(a.anchorMass_kg, 0, "kg, ") +
                                          shown(a.cableLength_m / core::kShackle_m, 0, "shackles")});
    if (card.anchors.empty()) card.anchors.push_back({"Anchors", "none"});
}

std::string percent(double share) { return shown(100.0 * share, 0, "%"); }

void fillSteering(PilotCardData& card, const core::Vessel& v) {
    const core::Steering& s = v.steering;
    const double sweep_deg =
        s.limit_rad / core::kDegree_rad + std::min(30.0, s.limit_rad / core::kDegree_rad);
    const double rate_degps = s.rate_radps / core::kDegree_rad;
    if (!s.rudders.empty())
        card.steering.push_back(
            {"Rudders", std::to_string(s.rudders.size()) + ", " + shown(s.areaEach_m2, 1, "m2 each")});
    else
        card.steering.push_back({"Rudders", "none: the wheel turns the drives"});
    card.steering.push_back({"Maximum angle", shown(s.limit_rad / core::kDegree_rad, 0, "deg")});
    card.steering.push_back(
        {"Hard over to 30 deg other side", shown(sweep_deg / rate_degps, 0, "s, two pumps")});
    card.steering.push_back({"", shown(2.0 * sweep_deg / rate_degps, 0, "s, one pump")});
    for (const core::Thruster& t : v.thrusters.units)
        card.steering.push_back({"Thruster, " + t.id, shown(1e-3 * t.thrust_N, 0, "kN")});
}

/// Thrust at rest with the order full astern over that with full ahead, engines allowing.
double asternShare(const core::Vessel& v) {
    const core::PropulsionUnit& unit = v.propulsion.units.front();
    if (!unit.openWater) return unit.asternThrustRatio;
    const core::Propeller screw(unit);
    const auto thrust_N = [&](core::TelegraphStep step) {
        core::ShaftState lever;
        lever.order_rps = v.propulsion.telegraph_rps[static_cast<std::size_t>(step)];
        const core::ShaftDemand d = core::demandOf(unit, lever);
        return screw.force(d.speed_rps, d.pitch, 0.0, v.hull.waterDensity_kgpm3).thrust_N;
    };
    return -thrust_N(core::TelegraphStep::FullAstern) / thrust_N(core::TelegraphStep::FullAhead);
}

std::string kindOf(const core::PropulsionUnit& unit) {
    const std::string blades = unit.pitch ? "controllable pitch" : "fixed pitch";
    return unit.azimuth ? blades + ", azimuth drives" : blades;
}

void fillPropulsion(PilotCardData& card, const core::Vessel& v) {
    const core::PropulsionUnit& unit = v.propulsion.units.front();
    card.propulsion = {{"Propellers", std::to_string(v.propulsion.units.size()) + ", " + kindOf(unit)},
                       {"Diameter", shown(unit.diameter_m, 2, "m")}};
    if (const auto& engine = unit.engine) {
        const double power_W = core::kTwoPi * engine->torque_Nm * engine->full_rps;
        card.propulsion.push_back({"Engine power, each shaft", shown(1e-3 * power_W, 0, "kW")});
        if (engine->startAir)
            card.propulsion.push_back({"Starts in the bottles", shown(engine->startAir->starts, 0)});
    }
    if (unit.pitch)
        card.propulsion.push_back({"Pitch, full ahead to full astern",
                                   shown((1.0 - unit.pitch->least) / unit.pitch->rate_perS, 0, "s")});
    else
        card.propulsion.push_back({"Stand between ahead and astern", shown(unit.reversingTime_s, 0, "s")});
    if (unit.azimuth)
        card.propulsion.push_back(
            {"Drives turn 180 deg in", shown(core::kPi / unit.azimuth->rate_radps, 0, "s")});
    card.propulsion.push_back({"Fastest change", shown(unit.shaftRate_rpsps / core::kRpm_rps, 1, "rpm/s")});
    card.propulsion.push_back({"Astern thrust", percent(asternShare(v)).append(" of ahead")});
}

/// Shaft speeds as the indicator shows them; where blades turn, their pitch with the order.
void fillTelegraph(PilotCardData& card, const core::Vessel& v, std::string_view model) {
    const core::PropulsionUnit& unit = v.propulsion.units.front();
    const auto speeds = core::telegraphSpeeds_mps(v, model);
    for (std::size_t i = core::kTelegraphSteps; i-- > 0;) {
        core::ShaftState lever;
        lever.order_rps = v.propulsion.telegraph_rps[i];
        const core::ShaftDemand demand = core::demandOf(unit, lever);
        std::string order = wordsOf(core::telegraphStepName(static_cast<core::TelegraphStep>(i)));
        if (unit.pitch) order += ", pitch " + percent(demand.pitch);
        card.telegraph.push_back({order, demand.speed_rps / core::kRpm_rps, speeds[i] / core::kKnot_mps});
    }
}

void fillTurning(PilotCardData::Condition& card, const core::StandardTrials& trials) {
    const double L = trials.turnStarboard.length_m;
    for (const auto& [side, trial] :
         {std::pair<std::string, const core::Trial*>{"starboard", &trials.turnStarboard},
          {"port", &trials.turnPort}}) {
        const auto metres = [&, t = trial](const char* name) {
            const auto value = t->measure(name);
            return value ? shown(*value * L, 0, "m, ") + shown(*value, 1, "L") : std::string("not reached");
        };
        card.turning.push_back({"Advance, " + side, metres("advance_over_L")});
        card.turning.push_back({"Transfer, " + side, metres("transfer_over_L")});
        card.turning.push_back({"Tactical diameter, " + side, metres("tactical_diameter_over_L")});
        if (const auto t = trial->measure("t90_s"))
            card.turning.push_back({"Time to 90 deg, " + side, shown(*t, 0, "s")});
    }
    if (const auto ratio = trials.turnStarboard.measure("steady_speed_ratio"))
        card.turning.push_back({"Speed left in the turn", shown(100.0 * *ratio, 0, "%")});
    const auto track = [](const core::Trial& trial, std::vector<QPointF>& to) {
        for (const core::TrialSample& s : trial.samples)
            if (std::abs(s.heading_rad) <= core::kTwoPi) to.emplace_back(s.y_m, s.x_m);
    };
    track(trials.turnStarboard, card.starboard);
    track(trials.turnPort, card.port);
    double next_s = 60.0;
    for (const core::TrialSample& s : trials.turnStarboard.samples) {
        if (s.time_s < next_s || std::abs(s.heading_rad) > core::kTwoPi) continue;
        card.starboardTimes.emplace_back(s.y_m, s.x_m);
        next_s += 60.0;
    }
}

void fillStops(PilotCardData::Condition& card, const core::Vessel& v, const TriedIn& in) {
    core::TrialShip ship(v, in.model, in.depth_m);
    for (const auto step : {core::TelegraphStep::FullAhead, core::TelegraphStep::HalfAhead,
                            core::TelegraphStep::SlowAhead, core::TelegraphStep::DeadSlowAhead}) {
        core::TrialOptions options;
        options.approach = ship.steadyAt(v.propulsion.telegraph_rps[static_cast<std::size_t>(step)]);
        const core::Trial stop = core::runCrashStop(ship, {}, options);
        if (!stop.measure("stopping_time_s")) continue;
        card.stops.push_back({wordsOf(core::telegraphStepName(step)),
                              options.approach->speed_mps / core::kKnot_mps, *stop.measure("stopping_time_s"),
                              *stop.measure("head_reach_over_L") * stop.length_m,
                              *stop.measure("side_reach_over_L") * stop.length_m});
    }
}

}  // namespace

PilotCardData::Condition conditionOf(const core::Vessel& v, const core::StandardTrials& trials,
                                     const TriedIn& in) {
    PilotCardData::Condition condition;
    condition.title = in.title;
    condition.approach_kn = trials.turnStarboard.approach_mps / core::kKnot_mps;
    fillTurning(condition, trials);
    fillStops(condition, v, in);
    return condition;
}

PilotCardData pilotCardOf(const core::Vessel& v, const core::StandardTrials& trials, const std::string& date,
                          const TriedIn& in) {
    PilotCardData card;
    card.ship = v.name;
    card.type = v.type;
    card.date = date;
    card.length_m = v.hull.lengthBp_m;
    fillParticulars(card, v);
    fillSteering(card, v);
    fillPropulsion(card, v);
    fillTelegraph(card, v, in.model);
    card.conditions.push_back(conditionOf(v, trials, in));
    for (const core::ImoCheck& check : core::imoChecks(trials)) {
        const char* unit = check.unit == "L" ? "L" : "deg";
        card.checks.push_back({check.criterion, check.value ? shown(*check.value, 1, unit) : "not reached",
                               shown(check.limit, 1, unit), check.met()});
    }
    const auto source = [&](const char* group, const core::Provenance& p) {
        card.sources.push_back({group, core::qualityName(p.quality), p.source});
    };
    source("Hull", v.hull.provenance);
    source("Ship model", v.model(in.model).value()->provenance);
    source("Propulsion", v.propulsion.provenance);
    source("Steering", v.steering.provenance);
    source("Anchors", v.groundTackle.provenance);
    return card;
}

}  // namespace sagara::ui
