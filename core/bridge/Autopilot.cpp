#include "core/bridge/Autopilot.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/bridge/OwnShip.h"

namespace sagara::core {
namespace {

constexpr double kSlowest_mps = 1.0;    // below, the rudder hardly works and gains stop growing
constexpr double kHeadingGain = 1.2;    // rudder per heading error
constexpr double kLeastRateGain = 0.7;  // rudder per r L/U
constexpr double kDamping = 0.85;       // of the heading, 1 is critical
constexpr double kTurnGain = 1.0;       // rudder per wanted r L/U: K' of a well-behaved ship is about 1
// Time constant of the rate of turn in L/U: waves are not steered against.
constexpr double kSmoothing = 0.25;
constexpr double kLeastLookAhead_lengths = 1.5;
constexpr double kLookAhead = 2.4;      // over 1 / (natural frequency of the heading), in lengths run
constexpr double kLead_lengths = 0.8;   // the turn begins this much before the arc
constexpr double kIntegralTime = 12.0;  // in L/U
constexpr double kMostDrift_rad = 20.0 * kDegree_rad;  // that the integral takes out

/// Line of sight is stable while the heading follows it faster than it turns: heading hold with our gain has
/// the natural frequency sqrt(kHeadingGain K' / T') per L/U.
double lookAhead_lengths(const TurningIndices& turning) {
    return std::max(kLeastLookAhead_lengths,
                    kLookAhead * std::sqrt(turning.lag / (kHeadingGain * turning.gain)));
}

/// Nomoto's ship under rudder kp times the error less kd r: T' s^2 + (1 + K' kd) s + K' kp = 0.
double rateGain(const TurningIndices& turning) {
    const double critical = 2.0 * std::sqrt(turning.gain * turning.lag * kHeadingGain);
    return std::max(kLeastRateGain, (kDamping * critical - 1.0) / turning.gain);
}

double speed(const ShipMotion& m) { return std::max(kSlowest_mps, std::abs(m.surge_mps)); }

}  // namespace

double steerHeading_rad(const OwnShip& ship, const ShipMotion& m, double heading_rad, double turn_radps) {
    const double pace_s = ship.vessel.hull.lengthBp_m / speed(m);
    const double error_rad = wrapPi(heading_rad - m.heading_rad);
    const double rudder_rad = kHeadingGain * error_rad +
                              rateGain(ship.turning) * pace_s * (turn_radps - m.yawRate_radps) +
                              kTurnGain * pace_s * turn_radps;
    return std::clamp(rudder_rad, -ship.vessel.steering.limit_rad, ship.vessel.steering.limit_rad);
}

double steerTrack_rad(const OwnShip& ship, const RoutePath& path, const ShipMotion& m, AutopilotState& state,
                      double dt_s) {
    const double length_m = ship.vessel.hull.lengthBp_m;
    const bool somewhere = state.along_m == kSomewhere_m;
    const RoutePath::Place here = somewhere ? path.nearest(m.position(), 0.0, 0.0, path.length_m())
                                            : path.nearest(m.position(), state.along_m, 50.0, 300.0);
    state.along_m = here.along_m;
    const double lookAhead_m = lookAhead_lengths(ship.turning) * length_m,
                 integralTime_s = kIntegralTime * length_m / speed(m);
    // As far off as the most drift that it can take out would carry her: nothing is gathered on the way in.
    const double carried_m = std::tan(kMostDrift_rad) * lookAhead_m, limit_ms = carried_m * integralTime_s;
    if (std::abs(here.offTrack_m) < carried_m) {
        state.offTrackSum_ms = std::clamp(state.offTrackSum_ms + here.offTrack_m * dt_s, -limit_ms, limit_ms);
    }
    const RoutePath::Place ahead = path.at(here.along_m + kLead_lengths * length_m);
    const double towards_rad =
        std::atan2(here.offTrack_m + state.offTrackSum_ms / integralTime_s, lookAhead_m);
    state.setHeading_rad = ahead.course_rad - towards_rad;
    return steerHeading_rad(ship, m, state.setHeading_rad, speed(m) * ahead.curvature_perM);
}

double steerAutopilot_rad(const OwnShip& ship, const RoutePath& path, const ShipMotion& m,
                          AutopilotState& state, double handOrder_rad, double dt_s) {
    const double smoothing_s = kSmoothing * ship.vessel.hull.lengthBp_m / speed(m);
    state.yawRate_radps += (m.yawRate_radps - state.yawRate_radps) * dt_s / (smoothing_s + dt_s);
    ShipMotion smooth = m;
    smooth.yawRate_radps = state.yawRate_radps;
    if (state.mode == AutopilotMode::Heading)
        return steerHeading_rad(ship, smooth, state.setHeading_rad, 0.0);
    if (state.mode == AutopilotMode::Track && path.length_m() > 0.0)
        return steerTrack_rad(ship, path, smooth, state, dt_s);
    return handOrder_rad;
}

}  // namespace sagara::core
