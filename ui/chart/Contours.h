#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/world/Area.h"

namespace sagara::chart {

/// All lines of one depth, below chart datum.
struct Contour {
    double depth_m = 0.0;
    std::vector<std::vector<core::NorthEast>> lines;
};

/// Lines of equal value of a grid: marching squares with linear interpolation on the cell edges, joined and
/// lightly simplified (to a twentieth of the spacing). A closed line repeats its first point at its end. A
/// node that has the value itself counts as deeper. `skip(centre)`: cells that are left out.
std::vector<std::vector<core::NorthEast>> contourLines(const core::Grid& grid, double value,
                                                       const std::function<bool(core::NorthEast)>& skip = {});

/// Depth contours of an area from its finest grid at each place. Depths with no line anywhere are left out.
std::vector<Contour> contoursOf(const core::Area& area, std::span<const double> depths_m);

/// The part of a grid that is at least so deep, as closed rings: filled by the odd-even rule they give it,
/// holes and all. Where it reaches the edge of the grid the rings run along that edge.
std::vector<std::vector<core::NorthEast>> deeperThan(const core::Grid& grid, double value);

}  // namespace sagara::chart
