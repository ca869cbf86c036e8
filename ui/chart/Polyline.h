#pragma once

#include <span>
#include <vector>

#include "core/base/Planar.h"

namespace sagara::chart {

/// The same line with fewer points: none that is left out was farther than the tolerance from what is drawn
/// (Douglas and Peucker 1973). First and last point stay; a closed line repeats its first point at its end.
std::vector<core::NorthEast> simplified(std::span<const core::NorthEast> line, double tolerance_m);

}  // namespace sagara::chart
