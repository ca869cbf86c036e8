#include "core/motion/Waterplane.h"

#include <cmath>

namespace sagara::core {

Waterplane waterplaneOf(const Hull& hull) {
    const double a = 3.0 * hull.waterplaneCoefficient - 2.0;
    const double secondMoment_m4 = (1.0 / 30.0 + a / 20.0) * hull.beam_m * std::pow(hull.lengthBp_m, 3);
    const double length_m = std::sqrt(12.0 * secondMoment_m4 / hull.waterplaneArea_m2());
    return {length_m, hull.waterplaneArea_m2() / length_m};
}

WaveIntegrals waveIntegrals(const Waterplane& waterplane, double kx_radpm, double ky_radpm,
                            double phase_rad) {
    const double l = waterplane.length_m, w = waterplane.breadth_m;
    const ShapeFactors x = shapeFactors(0.5 * kx_radpm * l), y = shapeFactors(0.5 * ky_radpm * w);
    const double s = std::sin(phase_rad), c = std::cos(phase_rad);
    return {.integral_m2 = l * w * s * x.mean * y.mean,
            .firstMomentX_m3 = w * l * l * l / 12.0 * kx_radpm * c * x.slope * y.mean,
            .firstMomentY_m3 = l * w * w * w / 12.0 * ky_radpm * c * x.mean * y.slope};
}

}  // namespace sagara::core
