#include "core/identify/TurningCircle.h"

#include <algorithm>
#include <cmath>

#include "core/identify/TrialShip.h"

namespace sagara::core {
namespace {

/// Means over time of what is steady at the end of the turn.
struct SteadyMeans {
    double time_s = 0.0, speed = 0.0, yawRate = 0.0, surge = 0.0, sway = 0.0;

    void add(const TrialShip& ship, double step_s) {
        time_s += step_s;
        speed += step_s * ship.speed_mps();
        yawRate += step_s * ship.motion().yawRate_radps;
        surge += step_s * ship.motion().surge_mps;
        sway += step_s * ship.motion().sway_mps;
    }
};

std::string titleOf(const TurningCircle& turn) {
    const double angle_deg = std::round(std::abs(turn.rudder_rad) / kDegree_rad * 10.0) / 10.0;
    return "Turning circle, " + config::formatNumber(angle_deg) +
           (turn.rudder_rad < 0.0 ? " deg to port" : " deg to starboard");
}

}  // namespace

Trial runTurningCircle(TrialShip& ship, const TurningCircle& turn, const TrialOptions& options) {
    Trial trial;
    trial.title = titleOf(turn);
    const double length_m = trial.length_m = ship.vessel().hull.lengthBp_m;
    const Approach approach = options.approach ? *options.approach : ship.fullAhead();
    constexpr double kLongest_lengths = 150.0;
    TrialRecord record(trial, options, approach, kLongest_lengths * length_m / approach.speed_mps);
    ship.begin(approach);
    ship.orderRudder(turn.rudder_rad);

    const double side = turn.rudder_rad < 0.0 ? -1.0 : 1.0;
    const auto note = [&](const char* name, double value) { trial.measures.push_back({name, value}); };
    note("initial_U_ms", approach.speed_mps);
    SteadyMeans steady;
    double turned_rad = 0.0, farthest_m = 0.0, widest_m = 0.0, maxRoll_rad = 0.0, minRoll_rad = 0.0;
    while (record.goesOn(ship, turned_rad / turn.turn_rad) &&
           (options.duration_s || turned_rad < turn.turn_rad)) {
        const TrialSample before = ship.sample();
        ship.step(options.step_s);
        const TrialSample now = ship.sample();
        const double was_rad = turned_rad;
        turned_rad = side * now.heading_rad;
        const auto at = [&](double heading_rad, double TrialSample::*field) {
            const double f = (heading_rad - was_rad) / (turned_rad - was_rad);
            return before.*field + f * (now.*field - before.*field);
        };
        const auto passes = [&](double heading_rad) {
            return was_rad < heading_rad && turned_rad >= heading_rad;
        };
        if (passes(0.5 * kPi) && !trial.measure("t90_s")) {
            note("advance_over_L", at(0.5 * kPi, &TrialSample::x_m) / length_m);
            note("transfer_over_L", side * at(0.5 * kPi, &TrialSample::y_m) / length_m);
            note("t90_s", at(0.5 * kPi, &TrialSample::time_s));
            note("U90_ms", ship.speed_mps());
        }
        if (passes(kPi) && !trial.measure("t180_s")) {
            note("tactical_diameter_over_L", side * at(kPi, &TrialSample::y_m) / length_m);
            note("t180_s", at(kPi, &TrialSample::time_s));
            note("U180_ms", ship.speed_mps());
        }
        farthest_m = std::max(farthest_m, now.x_m);
        widest_m = std::max(widest_m, side * now.y_m);
        maxRoll_rad = std::max(maxRoll_rad, now.roll_rad);
        minRoll_rad = std::min(minRoll_rad, now.roll_rad);
        if (turned_rad >= kTwoPi && turned_rad <= 2.0 * kTwoPi) steady.add(ship, options.step_s);
    }
    record.finish(ship);
    if (trial.measure("t180_s")) {
        note("max_advance_over_L", farthest_m / length_m);
        note("max_transfer_over_L", widest_m / length_m);
    }
    if (steady.time_s > 0.0) {
        const double U_mps = steady.speed / steady.time_s, r_radps = steady.yawRate / steady.time_s;
        note("steady_diameter_over_L", 2.0 * U_mps / std::abs(r_radps) / length_m);
        note("steady_r_dps", r_radps / kDegree_rad);
        note("steady_U_ms", U_mps);
        note("steady_speed_ratio", U_mps / approach.speed_mps);
        const double drift_deg = std::atan2(-steady.sway, steady.surge) / kDegree_rad;
        note("steady_drift_deg", side * drift_deg);
        note("steady_beta_deg", drift_deg);
    }
    const double roll_rad = ship.motion().roll_rad;
    note("max_roll_deg", maxRoll_rad / kDegree_rad);
    note("min_roll_deg", minRoll_rad / kDegree_rad);
    note("final_roll_deg", roll_rad / kDegree_rad);
    note("max_heel_to_port_deg", std::max(0.0, -minRoll_rad) / kDegree_rad);
    note("max_heel_to_starboard_deg", std::max(0.0, maxRoll_rad) / kDegree_rad);
    note("steady_heel_to_port_deg", -roll_rad / kDegree_rad);
    return trial;
}

Trial runTurningCircle(const Vessel& vessel, const TurningCircle& turn, const TrialOptions& options) {
    TrialShip ship(vessel);
    return runTurningCircle(ship, turn, options);
}

}  // namespace sagara::core
