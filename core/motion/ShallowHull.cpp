#include "core/motion/ShallowHull.h"

#include <algorithm>

#include "core/motion/MmgShallow.h"

namespace sagara::core {

Load shallowHullLoad(const Hull& hull, const Load& deep, const Load& deepDrift, double surge_mps,
                     double depth_m) {
    constexpr double kNothing = 6.0, kWhole = 3.0;  // depth over draught
    const double share = std::clamp((kNothing - depth_m / hull.draught_m) / (kNothing - kWhole), 0.0, 1.0);
    if (share == 0.0) return {};
    const ShallowFactors f = shallowFactors(hull, depth_m);
    const bool resists = deep.surge_N * surge_mps < 0.0;
    return {.surge_N = resists ? share * (f.resistance - 1.0) * deep.surge_N : 0.0,
            .sway_N = share * std::max(0.0, f.Yv - 1.0) * deepDrift.sway_N,
            .yaw_Nm = share * (std::max(0.0, f.Nv - 1.0) * deepDrift.yaw_Nm +
                               std::max(0.0, f.Nr - 1.0) * (deep.yaw_Nm - deepDrift.yaw_Nm))};
}

}  // namespace sagara::core
