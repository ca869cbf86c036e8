#include "core/identify/CrashStop.h"

#include "core/base/Units.h"
#include "core/identify/TrialShip.h"

namespace sagara::core {
namespace {

/// "fullAstern" as "full astern".
std::string spoken(TelegraphStep step) {
    std::string text;
    for (const char* c = telegraphStepName(step); *c != '\0'; ++c) {
        const bool capital = *c >= 'A' && *c <= 'Z';
        if (capital) text += ' ';
        text += static_cast<char>(capital ? *c - 'A' + 'a' : *c);
    }
    return text;
}

}  // namespace

Trial runCrashStop(TrialShip& ship, const CrashStop& stop, const TrialOptions& options) {
    Trial trial;
    trial.title = "Stopping, " + spoken(stop.order);
    const double length_m = trial.length_m = ship.vessel().hull.lengthBp_m;
    const Approach approach = options.approach ? *options.approach : ship.fullAhead();
    constexpr double kLongest_lengths = 120.0;
    TrialRecord record(trial, options, approach, kLongest_lengths * length_m / approach.speed_mps);
    ship.begin(approach);
    ship.orderShafts(ship.vessel().propulsion.telegraph_rps[static_cast<std::size_t>(stop.order)]);
    ship.orderRudder(stop.rudder_rad);
    const auto note = [&](const char* name, double value) { trial.measures.push_back({name, value}); };
    const auto backwards = [](const TrialShip& s) { return -s.motion().surge_mps; };
    double track_m = 0.0;
    bool stopped = false;
    while (record.goesOn(ship, 1.0 - ship.motion().surge_mps / approach.speed_mps) &&
           (options.duration_s || !stopped)) {
        if (stopped) {
            ship.step(options.step_s);
            continue;
        }
        track_m += options.step_s * ship.speed_mps();
        ship.stepThrough(options.step_s, backwards, [&] {
            stopped = true;
            const TrialSample now = ship.sample();
            note("track_reach_over_L", track_m / length_m);
            note("head_reach_over_L", now.x_m / length_m);
            note("side_reach_over_L", now.y_m / length_m);
            note("stopping_time_s", now.time_s);
            note("stopping_heading_deg", now.heading_rad / kDegree_rad);
        });
    }
    record.finish(ship);
    return trial;
}

Trial runCrashStop(const Vessel& vessel, const CrashStop& stop, const TrialOptions& options) {
    TrialShip ship(vessel);
    return runCrashStop(ship, stop, options);
}

}  // namespace sagara::core
