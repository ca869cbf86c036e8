#include "core/sea/Nearshore.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/sea/Dispersion.h"

namespace sagara::core {
namespace {

constexpr double kDry_m = 0.05;

}  // namespace

double shoalingCoefficient(double period_s, double fromDepth_m, double depth_m) {
    const auto group = [&](double h) {
        return groupSpeed_mps(waveNumber_radpm(kTwoPi / period_s, h, kGravity_mps2), h, kGravity_mps2);
    };
    return std::sqrt(group(fromDepth_m) / group(std::max(depth_m, kDry_m)));
}

double breakingHeight_m(double period_s, double depth_m) {
    if (depth_m <= kDry_m) return 0.0;
    const double k = waveNumber_radpm(kTwoPi / period_s, depth_m, kGravity_mps2);
    return 0.88 / k * std::tanh(0.6 * k * depth_m / 0.88);
}

}  // namespace sagara::core
