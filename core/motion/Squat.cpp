#include "core/motion/Squat.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

double barrass_m(const SquatHull& hull, double speed_kn, double depth_m, double width_m) {
    const double width = std::min(width_m, 7.04 * hull.beam_m / std::pow(hull.block, 0.85));
    const double blockage = std::min(0.98 * hull.beam_m * hull.draught_m / (width * depth_m), 0.9);
    return hull.block * std::pow(blockage / (1.0 - blockage), 2.0 / 3.0) * std::pow(speed_kn, 2.08) / 30.0;
}

double icorels_m(const SquatHull& hull, double speed_mps, double depth_m) {
    const double froude = std::min(speed_mps / std::sqrt(kGravity_mps2 * depth_m), 0.99);
    const double slenderness_m = hull.block * hull.beam_m * hull.draught_m / hull.lengthBp_m;
    return 2.4 * slenderness_m * froude * froude / std::sqrt(1.0 - froude * froude);
}

double yoshimura_m(const SquatHull& hull, double speed_mps, double depth_m) {
    const double ratio = hull.draught_m / depth_m, form = hull.block * hull.beam_m / hull.lengthBp_m;
    return ((0.7 + 1.5 * ratio) * form + 15.0 * ratio * form * form * form) * speed_mps * speed_mps /
           kGravity_mps2;
}

}  // namespace

double squat_m(SquatFormula formula, const SquatHull& hull, double speedThroughWater_mps, double depth_m,
               double width_m) {
    const double speed_mps = std::abs(speedThroughWater_mps), speed_kn = speed_mps / kKnot_mps;
    const double depth = std::max(depth_m, hull.draught_m);
    switch (formula) {
        case SquatFormula::BarrassSimple:
            return hull.block * speed_kn * speed_kn / (std::isinf(width_m) ? 100.0 : 50.0);
        case SquatFormula::Barrass:
            return barrass_m(hull, speed_kn, depth, width_m);
        case SquatFormula::Icorels:
            return icorels_m(hull, speed_mps, depth);
        case SquatFormula::Yoshimura:
            return yoshimura_m(hull, speed_mps, depth);
    }
    return 0.0;
}

double squatUnderWay_m(SquatFormula formula, const SquatHull& hull, double speedThroughWater_mps,
                       double depth_m) {
    const bool simple = formula == SquatFormula::BarrassSimple;
    const double from = simple ? 2.5 : 5.0, whole = simple ? 1.4 : 4.0;
    const double shallow = std::clamp((from - depth_m / hull.draught_m) / (from - whole), 0.0, 1.0);
    return shallow > 0.0 ? shallow * squat_m(formula, hull, speedThroughWater_mps, depth_m) : 0.0;
}

}  // namespace sagara::core
