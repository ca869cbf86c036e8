#pragma once

#include <algorithm>
#include <cmath>

namespace sagara::render {

/// Share of the sea that white caps cover in a wind: Monahan and O'Muircheartaigh (1980), J. Phys.
/// Oceanogr. 10.
inline double whiteCapShare(double wind_mps) {
    return std::min(0.5, 3.84e-6 * std::pow(std::max(0.0, wind_mps), 3.41));
}

/// The downward acceleration of the surface, in standard deviations, that just so much of a Gaussian sea
/// exceeds: where it is more, the crest breaks. Abramowitz and Stegun 26.2.23, error below 4.5e-4.
inline double breakingAcceleration(double wind_mps) {
    const double t = std::sqrt(-2.0 * std::log(std::max(1e-9, whiteCapShare(wind_mps))));
    return t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                   (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

}  // namespace sagara::render
