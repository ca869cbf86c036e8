#include "core/identify/Pullout.h"

#include "core/identify/Settling.h"
#include "core/identify/TrialShip.h"

namespace sagara::core {

Trial runPullout(TrialShip& ship, const Pullout& pullout, const TrialOptions& options) {
    Trial trial;
    trial.title = pullout.rudder_rad < 0.0 ? "Pull-out from port" : "Pull-out from starboard";
    const double length_m = trial.length_m = ship.vessel().hull.lengthBp_m;
    const Approach approach = options.approach ? *options.approach : ship.fullAhead();
    constexpr double kLongest_lengths = 200.0;
    const double pace_s = length_m / approach.speed_mps;
    TrialRecord record(trial, options, approach, kLongest_lengths * pace_s);
    ship.begin(approach);
    ship.orderRudder(pullout.rudder_rad);
    const auto note = [&](const char* name, double value) { trial.measures.push_back({name, value}); };
    Settling turn(ship, pace_s);
    while (record.goesOn(ship, 0.0)) {
        ship.step(options.step_s);
        if (turn.settled(ship, options.step_s)) break;
    }
    note("steady_r_dps", turn.yawRate_radps() / kDegree_rad);
    note("release_time_s", ship.state().time_s);
    ship.orderRudder(0.0);
    Settling after(ship, pace_s);
    bool settled = false;
    while (record.goesOn(ship, 0.5) && (options.duration_s || !settled)) {
        ship.step(options.step_s);
        settled = after.settled(ship, options.step_s) || settled;
    }
    record.finish(ship);
    note("residual_yaw_rate_dps", after.yawRate_radps() / kDegree_rad);
    note("residual_ratio", after.yawRate_radps() / turn.yawRate_radps());
    return trial;
}

}  // namespace sagara::core
