#pragma once

#include "core/world/Area.h"

namespace sagara::core {

/// B/2 (1/y_starboard - 1/y_port) for Norrbin's bank loads, where neither side is a vertical wall: 1/y is the
/// integral of b dy/y^2 from the ship's side outward, b the part of the depth under her that the ground fills
/// at the distance y abeam; a wall at y gives just 1/y. Mean of three stations; looks ten beams out. 0 on the
/// centreline of a symmetric channel and in open water. `depth_m` under her, `tide_m` above chart datum.
double bankAsymmetry(const Area& area, NorthEast position, double heading_rad, double length_m, double beam_m,
                     double depth_m, double tide_m);

}  // namespace sagara::core
