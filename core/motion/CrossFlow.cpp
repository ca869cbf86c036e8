#include "core/motion/CrossFlow.h"

#include <cmath>

namespace sagara::core {

Load crossFlowDrag(const Hull& hull, double dragCoefficient, double sway_mps, double yawRate_radps) {
    constexpr int kStrips = 12;
    const double step_m = hull.lengthBp_m / kStrips;
    Load drag;
    for (int i = 0; i < kStrips; ++i) {
        const double x_m = (i + 0.5) * step_m - 0.5 * hull.lengthBp_m;
        const double lateral_mps = sway_mps + yawRate_radps * x_m;
        const double force_N = -0.5 * hull.waterDensity_kgpm3 * dragCoefficient * hull.draught_m * step_m *
                               lateral_mps * std::abs(lateral_mps);
        drag.sway_N += force_N;
        drag.yaw_Nm += x_m * force_N;
    }
    return drag;
}

}  // namespace sagara::core
