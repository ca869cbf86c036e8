#pragma once

#include <vector>

#include "core/exercise/World.h"
#include "render/scene/Camera.h"
#include "render/scene/shape/Solid.h"

namespace sagara::render {

/// A mooring line or an anchor cable as it hangs now.
struct Rope {
    std::vector<PlaceUp> points;  ///< from the ship outwards; ends just under water when it goes there
    double diameter_m = 0.05;
    Paint paint;
};

/// Lines and cables of all own ships. Fairleads, hawses and bollards are the World's, lengths the moment's.
std::vector<Rope> ropesOf(const core::World& world, const Moment& moment);

/// How far a line hangs through amidst a span: the parabola whose arc is the line's length stretched by its
/// own pull, d + 8 s^2 / 3d = L (1 + w d^2 / 8 s EA). All lengths positive.
double sag_m(double span_m, double length_m, double weight_Npm, double stiffness_N);

/// Upper part of an anchor cable: from the hawse along a catenary until `depth_m` below it.
struct CablePoint {
    double out_m;   ///< horizontally, towards the anchor
    double down_m;  ///< below the hawse
};
/// `horizontal_N` and `atHawse_N` as in core::CableShape. Straight down when there is no horizontal pull.
std::vector<CablePoint> hangingCable(double horizontal_N, double atHawse_N, double weight_Npm,
                                     double depth_m);

}  // namespace sagara::render
