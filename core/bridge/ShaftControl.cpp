#include "core/bridge/ShaftControl.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

std::int8_t wayOf(double speed_rps) {
    return static_cast<std::int8_t>(speed_rps > 0.0 ? 1 : speed_rps < 0.0 ? -1 : 0);
}

}  // namespace

void runShaft(const PropulsionUnit& unit, ShaftState& shaft, double dt_s) {
    const double order_rps = shaft.failed ? 0.0 : shaft.order_rps;
    const double most_rps = unit.shaftRate_rpsps * dt_s * (shaft.failed ? 1.0 / 3.0 : 1.0);
    if (shaft.speed_rps != 0.0) shaft.lastTurned = wayOf(shaft.speed_rps);
    // First to a stand, then the reversing time, then the other way.
    const bool reverses = wayOf(order_rps) * shaft.lastTurned < 0;
    const double target_rps = reverses ? 0.0 : order_rps;
    shaft.speed_rps += std::clamp(target_rps - shaft.speed_rps, -most_rps, most_rps);
    shaft.standing_s = shaft.speed_rps == 0.0 ? std::max(0.0, shaft.standing_s - dt_s) : unit.reversingTime_s;
    if (shaft.standing_s == 0.0) shaft.lastTurned = 0;
}

}  // namespace sagara::core
