#include "core/identify/Zigzag.h"

#include <algorithm>
#include <cmath>

#include "core/identify/TrialShip.h"

namespace sagara::core {
namespace {

std::string titleOf(const Zigzag& z) {
    const auto degrees = [](double rad) {
        return config::formatNumber(std::round(rad / kDegree_rad * 10.0) / 10.0);
    };
    return "Zigzag " + degrees(z.rudder_rad) + "/" + degrees(z.switch_rad) +
           (z.starboardFirst ? ", first to starboard" : ", first to port");
}

}  // namespace

Trial runZigzag(TrialShip& ship, const Zigzag& zigzag, const TrialOptions& options) {
    Trial trial;
    trial.title = titleOf(zigzag);
    const double length_m = trial.length_m = ship.vessel().hull.lengthBp_m;
    const Approach approach = options.approach ? *options.approach : ship.fullAhead();
    constexpr double kLongest_lengths = 150.0;
    TrialRecord record(trial, options, approach, kLongest_lengths * length_m / approach.speed_mps);
    ship.begin(approach);
    const auto note = [&](const std::string& name, double value) { trial.measures.push_back({name, value}); };
    double side = zigzag.starboardFirst ? 1.0 : -1.0;  // of the present execute
    ship.orderRudder(side * zigzag.rudder_rad);
    int execute = 1, overshoots = 0;
    double track_m = 0.0, peak_rad = 0.0, maxRoll_rad = 0.0;
    const double share = 1.0 / zigzag.executes, step_s = zigzag.look_s > 0.0 ? zigzag.look_s : options.step_s;
    while (record.goesOn(ship, share * (execute - 1)) &&
           (options.duration_s || overshoots < zigzag.executes - 1)) {
        track_m += step_s * ship.speed_mps();
        const auto past = [&](const TrialShip& s) {
            return side * s.motion().heading_rad - zigzag.switch_rad;
        };
        const auto reverse = [&] {
            ++execute;
            const double time_s = ship.sample().time_s;
            if (execute == 2) {
                note("initial_turning_time_s", time_s);
                note("initial_turning_over_L", track_m / length_m);
            }
            note("execute_" + std::to_string(execute) + "_time_s", time_s);
            side = -side;
            ship.orderRudder(side * zigzag.rudder_rad);
        };
        const bool reverses = execute < zigzag.executes || options.duration_s;
        if (reverses && zigzag.look_s == 0.0) {
            ship.stepThrough(step_s, past, reverse);
        } else {
            ship.step(step_s);
            if (reverses && past(ship) >= 0.0) reverse();
        }
        const TrialSample now = ship.sample();
        maxRoll_rad = std::max(maxRoll_rad, std::abs(now.roll_rad));
        if (overshoots == execute - 1) continue;
        // Past the switch of the execute before, on its side.
        peak_rad = std::max(peak_rad, -side * now.heading_rad - zigzag.switch_rad);
        if (side * now.yawRate_radps > 0.0) {  // swings back
            note("overshoot_" + std::to_string(++overshoots) + "_deg", peak_rad / kDegree_rad);
            peak_rad = 0.0;
        }
    }
    record.finish(ship);
    note("max_abs_roll_deg", maxRoll_rad / kDegree_rad);
    return trial;
}

Trial runZigzag(const Vessel& vessel, const Zigzag& zigzag, const TrialOptions& options) {
    TrialShip ship(vessel);
    return runZigzag(ship, zigzag, options);
}

}  // namespace sagara::core
