#include "core/motion/BankLoad.h"

#include <algorithm>

namespace sagara::core {

Load bankLoad(const Hull& hull, double eta, double surge_mps, double depth_m) {
    const double ratio = std::min(hull.draught_m / std::max(depth_m, 1e-3), 1.0), ratio2 = ratio * ratio;
    const double pressure = hull.mass_kg() * surge_mps * surge_mps;
    const double underKeel = depth_m / hull.draught_m - 1.0;
    const double suction = std::clamp((underKeel - 0.10) / 0.05, -0.5, 1.0);
    return {.sway_N = suction * pressure / hull.lengthBp_m * (0.0926 + 0.372 * ratio2) * eta,
            .yaw_Nm = -pressure * (0.025 + 0.0755 * ratio2) * eta};
}

}  // namespace sagara::core
