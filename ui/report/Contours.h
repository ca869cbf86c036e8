#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/world/Area.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// Lines of equal value of a grid: marching squares with linear interpolation on the cell edges, joined and
/// lightly simplified (to a twentieth of the spacing). A closed line repeats its first point at its end. A
/// node that has the value itself counts as deeper. `skip(centre)`: cells that are left out.
std::vector<std::vector<core::NorthEast>> contourLines(const core::Grid& grid, double value,
                                                       const std::function<bool(core::NorthEast)>& skip = {});

/// Depth contours of an area from its finest grid at each place. Depths with no line anywhere are left out.
std::vector<RunReport::Contour> contoursOf(const core::Area& area, std::span<const double> depths_m);

}  // namespace sagara::report
