#include "core/motion/Bow.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// ICLL 1966, regulation 39 (1), m above the summer load line.
double leastBowHeight_m(double length_m, double blockCoefficient) {
    const double form = 1.36 / (std::max(blockCoefficient, 0.68) + 0.68);
    return length_m < 250.0 ? 0.056 * length_m * (1.0 - length_m / 500.0) * form : 7.0 * form;
}

}  // namespace

Bow bowOf(const Hull& hull) {
    const double L = hull.lengthBp_m;
    return {0.5 * L, std::max(hull.depth_m - hull.draught_m, leastBowHeight_m(L, hull.blockCoefficient())),
            0.4 * L, hull.draught_m, 0.0935 * std::sqrt(kGravity_mps2 * L)};
}

double riseAt(const ShipMotion& m, double forward_m, double elevation_m) {
    return elevation_m + m.down_m - forward_m * std::sin(m.pitch_rad);
}

}  // namespace sagara::core
