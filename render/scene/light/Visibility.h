#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::render {

/// Strength of a light that is seen at its nominal range in a night with K = 0.8 to the mile: COLREG annex I,
/// section 8, 0.2 microlux at the eye.
inline double candela(double range_M) { return 3.43e6 * 2e-7 * range_M * range_M * std::pow(0.8, -range_M); }

/// What reaches the eye, in lux (Allard 1876).
inline double illuminance_lux(double strength_cd, double distance_m, double extinction_perM) {
    return strength_cd * std::exp(-extinction_perM * distance_m) / std::max(1.0, distance_m * distance_m);
}

/// How a point of light looks: brightness on the screen, 0 when it is not seen, and its size.
struct PointLook {
    double brightness = 0.0;
    double size_px = 0.0;
};
/// The eye needs 0.2 microlux at night and about a millilux by day.
inline PointLook lookOf(double lux, double night) {
    const double threshold = std::pow(10.0, -3.0 - 3.7 * night);
    const double decades = std::log10(std::max(1e-12, lux) / threshold);
    if (decades <= 0.0) return {};
    return {std::min(1.0, 0.35 + 0.35 * decades), 1.6 + 1.3 * decades + 4.0 * std::max(0.0, decades - 3.5)};
}

}  // namespace sagara::render
