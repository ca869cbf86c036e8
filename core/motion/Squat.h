#pragma once

#include <limits>

#include "core/vessel/ShallowWater.h"

namespace sagara::core {

/// What the squat formulas ask of a hull.
struct SquatHull {
    double lengthBp_m = 0.0;
    double beam_m = 0.0;
    double draught_m = 0.0;
    double block = 0.0;
};
inline constexpr double kOpenWater_m = std::numeric_limits<double>::infinity();

/// Largest sinkage of a ship under way, m, as published; `width_m` of the channel, kOpenWater_m for none.
/// BarrassSimple (1979): Cb Vk^2/100 open, /50 in a channel, h/T 1.1 to 1.4. Barrass (1979): Cb S2^(2/3)
/// Vk^2.08/30, S2 = S/(1-S), S = 0.98 B T/(W h), in the open with his width of influence 7.04 B/Cb^0.85.
/// Icorels (1980), Huuska's 2.4: 2.4 vol/L^2 F^2/sqrt(1-F^2), F the depth Froude number, held at 0.99 from
/// there on. Yoshimura (1986): ((0.7+1.5T/h) Cb B/L + 15 T/h (Cb B/L)^3) V^2/g. They differ by 30 %.
double squat_m(SquatFormula formula, const SquatHull& hull, double speedThroughWater_mps, double depth_m,
               double width_m = kOpenWater_m);

/// The same for a ship that goes from deep to shallow water: fades in from depth = 2.5 draughts and is whole
/// from 1.4 down for Barrass's simple form, which has no depth in it; from 5 to 4 draughts for the others.
double squatUnderWay_m(SquatFormula formula, const SquatHull& hull, double speedThroughWater_mps,
                       double depth_m);

}  // namespace sagara::core
