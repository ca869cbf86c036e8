#include "core/bridge/SteeringGear.h"

#include <algorithm>

namespace sagara::core {

double runSteeringGear(const Steering& steering, SteeringGearState& gear, double dt_s) {
    constexpr int kPumps = 2;
    const int running = gear.jammed ? 0 : std::max(0, kPumps - gear.pumpsFailed);
    const double order_rad = std::clamp(gear.order_rad, -steering.limit_rad, steering.limit_rad);
    const double most_rad = steering.rate_radps * dt_s * running / kPumps;
    // With a lag the gear slows as it nears the order; without, it runs at its rate until it is there.
    const double nearing = steering.lag_s > dt_s ? dt_s / steering.lag_s : 1.0;
    const double before_rad = gear.angle_rad;
    gear.angle_rad += std::clamp(nearing * (order_rad - gear.angle_rad), -most_rad, most_rad);
    return 0.5 * (before_rad + gear.angle_rad);
}

}  // namespace sagara::core
