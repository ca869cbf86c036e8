#pragma once

#include <vector>

#include "render/scene/Moment.h"

namespace sagara::render {

/// Foam of a moving ship as ribbons on the water: the wake astern, along the circle she is sailing on, and a
/// wave to each side of her bow. A pure function of her pose, so that every channel draws the same.
struct FoamPoint {
    core::NorthEast place;
    double across = 0.0;  ///< -1 one edge, 1 the other
    double along_m = 0.0;
    double strength = 0.0;
    double width_m = 0.0;
};
/// Two points a step, edge and edge; ribbons are separate.
using FoamRibbon = std::vector<FoamPoint>;
std::vector<FoamRibbon> foamOf(const ShipPose& pose, double length_m, double beam_m);

}  // namespace sagara::render
