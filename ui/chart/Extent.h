#pragma once

#include "core/base/Planar.h"

namespace sagara::chart {

/// A box in frame N; empty until a point was put in.
struct Extent {
    core::NorthEast southWest;
    core::NorthEast northEast;
    bool empty = true;

    void include(core::NorthEast p);
    core::NorthEast centre() const { return 0.5 * (southWest + northEast); }
    double height_m() const { return northEast.north_m - southWest.north_m; }
    double width_m() const { return northEast.east_m - southWest.east_m; }
};

}  // namespace sagara::chart
