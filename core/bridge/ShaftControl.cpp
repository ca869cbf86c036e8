#include "core/bridge/ShaftControl.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {

void runShaft(const PropulsionUnit& unit, ShaftState& shaft, double dt_s) {
    const double order_rps = shaft.failed ? 0.0 : shaft.order_rps;
    const double most_rps = unit.shaftRate_rpsps * dt_s * (shaft.failed ? 1.0 / 3.0 : 1.0);
    const auto wanted = static_cast<std::int8_t>(order_rps > 0.0 ? 1 : order_rps < 0.0 ? -1 : 0);
    const bool reverses = wanted != 0 && shaft.lastTurned != 0 && wanted != shaft.lastTurned;
    if (!reverses) {
        shaft.speed_rps += std::clamp(order_rps - shaft.speed_rps, -most_rps, most_rps);
        if (wanted != 0 && shaft.speed_rps != 0.0) shaft.lastTurned = wanted;
        shaft.standing_s = unit.reversingTime_s;
        return;
    }
    // First to a stand, then the reversing time, then the other way.
    if (shaft.speed_rps != 0.0) {
        shaft.speed_rps -= std::clamp(shaft.speed_rps, -most_rps, most_rps);
        return;
    }
    shaft.standing_s -= dt_s;
    if (shaft.standing_s <= 0.0) shaft.lastTurned = 0;
}

}  // namespace sagara::core
