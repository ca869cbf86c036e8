#pragma once

namespace sagara::core {

/// Largest sinkage of a ship under way in open shallow water, m: Cb V^2 / 100, V in knots (Barrass 1979,
/// simple form; holds for depth over draught 1.1 to 1.4). Here it fades in below depth = 2.5 draughts and is
/// whole from 1.4 down.
double squat_m(double blockCoefficient, double speedThroughWater_mps, double depth_m, double draught_m);

}  // namespace sagara::core
