#pragma once

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {

/// The same direction in (-pi, pi]: for differences of headings.
inline double wrapPi(double angle_rad) {
    const double turned = std::remainder(angle_rad, kTwoPi);
    return turned <= -kPi ? turned + kTwoPi : turned;
}

/// The same direction in [0, 2 pi): for display and for tables by direction.
inline double wrapTwoPi(double angle_rad) {
    const double turned = std::fmod(angle_rad, kTwoPi);
    const double positive = turned < 0.0 ? turned + kTwoPi : turned;
    return positive < kTwoPi ? positive : 0.0;
}

}  // namespace sagara::core
