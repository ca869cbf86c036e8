#include "core/motion/Thruster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

struct FadePoint {
    double speedRatio, force, moment;
};
constexpr std::array<FadePoint, 9> kFade{{{0.0, 1.0, 1.0},
                                          {0.1, 0.80, 0.92},
                                          {0.2, 0.62, 0.82},
                                          {0.3, 0.50, 0.74},
                                          {0.4, 0.44, 0.69},
                                          {0.5, 0.43, 0.67},
                                          {0.6, 0.46, 0.68},
                                          {0.8, 0.56, 0.74},
                                          {1.0, 0.67, 0.82}}};

}  // namespace

ThrusterFade thrusterFade(double speedRatio) {
    const double at = std::clamp(speedRatio, 0.0, kFade.back().speedRatio);
    std::size_t i = 1;
    while (kFade[i].speedRatio < at) ++i;
    const FadePoint &a = kFade[i - 1], &b = kFade[i];
    const double s = (at - a.speedRatio) / (b.speedRatio - a.speedRatio);
    return {a.force + s * (b.force - a.force), a.moment + s * (b.moment - a.moment)};
}

double jetSpeed_mps(const Thruster& thruster, double thrust_N, double density_kgpm3) {
    const double area_m2 = kPi / 4.0 * thruster.diameter_m * thruster.diameter_m;
    return std::sqrt(std::abs(thrust_N) / (density_kgpm3 * area_m2));
}

Load thrusterLoad(const Thruster& thruster, double share, double surge_mps, const Hull& hull) {
    constexpr double kIdle = 1e-4;
    if (std::abs(share) < kIdle) return {};
    const double atRest_N = share * thruster.thrust_N;
    const ThrusterFade fade =
        thrusterFade(std::abs(surge_mps) / jetSpeed_mps(thruster, atRest_N, hull.waterDensity_kgpm3));
    const double forward = std::clamp(thruster.position.x_m / hull.lengthBp_m, -0.5, 0.5);
    const double downstream = surge_mps >= 0.0 ? 0.5 + forward : 0.5 - forward;
    const double force_N = (1.0 - downstream * (1.0 - fade.force)) * atRest_N;
    Load load = forceAt(thruster.position, thruster.height_m, {0.0, force_N});
    load.yaw_Nm = (1.0 - downstream * (1.0 - fade.moment)) * thruster.position.x_m * atRest_N;
    return load;
}

Load thrusterLoad(const Thrusters& thrusters, const ShipMotion& m, const Actuators& actuators,
                  const Hull& hull) {
    Load sum;
    for (std::size_t i = 0; i < thrusters.units.size(); ++i)
        sum = sum + thrusterLoad(thrusters.units[i], actuators.thruster[i], m.surge_mps, hull);
    return sum;
}

}  // namespace sagara::core
