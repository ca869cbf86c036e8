#include "core/motion/ShallowHull.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kLeastDepth = 1.05, kDeepFrom = 6.0;  // over the draught

double drift(double exponent, double draughtOverDepth) {
    return std::pow(1.0 - draughtOverDepth, -exponent) - draughtOverDepth;
}

}  // namespace

ShallowFactors shallowFactors(const Hull& hull, double depth_m) {
    const double H = std::max(depth_m / hull.draught_m, kLeastDepth);
    const double beamOverDraught = hull.beam_m / hull.draught_m, block = hull.blockCoefficient();
    const double lengthOverDraught = hull.lengthBp_m / hull.draught_m;
    const double surge = std::pow(H - 1.0, 1.3), lateral = std::pow(H - 1.0, 0.82);
    ShallowFactors f;
    f.swayForce = drift(0.40 * block * beamOverDraught, 1.0 / H);
    f.yawMoment = drift(0.425 * block * beamOverDraught, 1.0 / H);
    f.surgeAddedMass =
        (surge + 3.77 + 1.14 * beamOverDraught - 0.233 * lengthOverDraught - 3.43 * block) / surge;
    f.swayAddedMass =
        (lateral + 0.413 + 0.032 * beamOverDraught + 0.0129 * beamOverDraught * beamOverDraught) / lateral;
    f.yawAddedInertia =
        (lateral + 0.413 + 0.0192 * beamOverDraught + 0.00554 * beamOverDraught * beamOverDraught) / lateral;
    return f;
}

double shallowResistanceFactor(const Hull& hull, double speed_mps, double depth_m) {
    const double depth = std::max(depth_m, kLeastDepth * hull.draught_m), speed = std::abs(speed_mps);
    if (speed < 1e-3) return 1.0;
    const double section_m2 = 0.98 * hull.beam_m * hull.draught_m;
    const double blockage = std::max(0.0, 0.1242 * (section_m2 / (depth * depth) - 0.05));
    double loss = 0.0;  // at the deep-water speed that has the same resistance
    for (int i = 0; i < 8; ++i) {
        const double deep_mps = speed / (1.0 - loss);
        const double wave = 1.0 - std::sqrt(std::tanh(kGravity_mps2 * depth / (deep_mps * deep_mps)));
        loss = std::clamp(blockage + wave, 0.0, 0.6);
    }
    return 1.0 / ((1.0 - loss) * (1.0 - loss));
}

Load shallowHullLoad(const Hull& hull, const Load& deepHullForce, double surge_mps, double depth_m) {
    const double H = depth_m / hull.draught_m;
    if (H >= kDeepFrom) return {};
    const double share = std::clamp(2.0 * (kDeepFrom - H) / kDeepFrom, 0.0, 1.0);  // whole from 3 draughts
    const ShallowFactors f = shallowFactors(hull, depth_m);
    const bool resists = deepHullForce.surge_N * surge_mps < 0.0;
    const double resistance = resists ? shallowResistanceFactor(hull, surge_mps, depth_m) : 1.0;
    return {.surge_N = share * (resistance - 1.0) * deepHullForce.surge_N,
            .sway_N = share * std::max(0.0, f.swayForce - 1.0) * deepHullForce.sway_N,
            .yaw_Nm = share * std::max(0.0, f.yawMoment - 1.0) * deepHullForce.yaw_Nm};
}

}  // namespace sagara::core
