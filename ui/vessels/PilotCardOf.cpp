#include "ui/vessels/PilotCardOf.h"

#include <QString>
#include <cmath>

#include "core/base/Units.h"
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

void fillMachinery(PilotCardData& card, const core::Vessel& v) {
    const core::Steering& s = v.steering;
    const double sweep_deg =
        s.limit_rad / core::kDegree_rad + std::min(30.0, s.limit_rad / core::kDegree_rad);
    const double rate_degps = s.rate_radps / core::kDegree_rad;
    card.steering = {
        {"Rudders", std::to_string(s.rudders.size()) + ", " + shown(s.areaEach_m2, 1, "m2 each")},
        {"Maximum angle", shown(s.limit_rad / core::kDegree_rad, 0, "deg")},
        {"Hard over to 30 deg other side", shown(sweep_deg / rate_degps, 0, "s, two pumps")},
        {"", shown(2.0 * sweep_deg / rate_degps, 0, "s, one pump")}};
    const core::PropulsionUnit& unit = v.propulsion.units.front();
    card.propulsion = {{"Propellers", std::to_string(v.propulsion.units.size()) + ", fixed pitch"},
                       {"Diameter", shown(unit.diameter_m, 2, "m")},
                       {"Stand between ahead and astern", shown(unit.reversingTime_s, 0, "s")},
                       {"Fastest change", shown(unit.shaftRate_rpsps / core::kRpm_rps, 1, "rpm/s")},
                       {"Astern thrust", shown(100.0 * unit.asternThrustRatio, 0, "% of ahead")}};
    const auto speeds = core::telegraphSpeeds_mps(v);
    for (std::size_t i = core::kTelegraphSteps; i-- > 0;) {
        const auto step = static_cast<core::TelegraphStep>(i);
        card.telegraph.push_back({wordsOf(core::telegraphStepName(step)),
                                  v.propulsion.telegraph_rps[i] / core::kRpm_rps,
                                  speeds[i] / core::kKnot_mps});
    }
}

void fillTurning(PilotCardData& card, const core::StandardTrials& trials) {
    const double L = card.length_m;
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

void fillStops(PilotCardData& card, const core::Vessel& v) {
    core::TrialShip ship(v);
    for (const auto step : {core::TelegraphStep::FullAhead, core::TelegraphStep::HalfAhead,
                            core::TelegraphStep::SlowAhead, core::TelegraphStep::DeadSlowAhead}) {
        core::TrialOptions options;
        options.approach = ship.steadyAt(v.propulsion.telegraph_rps[static_cast<std::size_t>(step)]);
        const core::Trial stop = core::runCrashStop(ship, {}, options);
        if (!stop.measure("stopping_time_s")) continue;
        card.stops.push_back({wordsOf(core::telegraphStepName(step)),
                              options.approach->speed_mps / core::kKnot_mps, *stop.measure("stopping_time_s"),
                              *stop.measure("head_reach_over_L") * stop.length_m});
    }
}

}  // namespace

PilotCardData pilotCardOf(const core::Vessel& v, const core::StandardTrials& trials,
                          const std::string& date) {
    PilotCardData card;
    card.ship = v.name;
    card.type = v.type;
    card.date = date;
    card.length_m = v.hull.lengthBp_m;
    card.approach_kn = trials.turnStarboard.approach_mps / core::kKnot_mps;
    fillParticulars(card, v);
    fillMachinery(card, v);
    fillTurning(card, trials);
    fillStops(card, v);
    for (const core::ImoCheck& check : core::imoChecks(trials)) {
        const char* unit = check.unit == "L" ? "L" : "deg";
        card.checks.push_back({check.criterion, check.value ? shown(*check.value, 1, unit) : "not reached",
                               shown(check.limit, 1, unit), check.met()});
    }
    const auto source = [&](const char* group, const core::Provenance& p) {
        card.sources.push_back({group, core::qualityName(p.quality), p.source});
    };
    source("Hull", v.hull.provenance);
    source("Ship model", v.models[0].provenance);
    source("Propulsion", v.propulsion.provenance);
    source("Steering", v.steering.provenance);
    source("Anchors", v.groundTackle.provenance);
    return card;
}

}  // namespace sagara::ui
