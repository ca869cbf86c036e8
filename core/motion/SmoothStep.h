#pragma once

#include <algorithm>

namespace sagara::core {

/// 0 up to `from`, 1 from `to` on, without a corner between.
inline double smoothStep(double from, double to, double x) {
    const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

}  // namespace sagara::core
