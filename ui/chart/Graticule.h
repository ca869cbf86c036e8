#pragma once

#include <vector>

#include "core/base/LocalFrame.h"
#include "ui/chart/Extent.h"

namespace sagara::chart {

/// One meridian or parallel across a chart, in frame N. In a frame of some miles they are straight to a
/// hair's breadth.
struct GridLine {
    double value_deg = 0.0;
    core::NorthEast from, to;  ///< west to east, south to north
};

/// Distance of the lines in minutes of arc: 0.01, 0.02, 0.05, 0.1 ... 60, at least `least_m` on the ground
/// (of latitude).
double graticuleStep_min(double least_m);

/// Parallels and meridians at multiples of a step that cross an extent; a hundred at most.
std::vector<GridLine> parallels(const core::LocalFrame& frame, const Extent& shown, double step_min);
std::vector<GridLine> meridians(const core::LocalFrame& frame, const Extent& shown, double step_min);

}  // namespace sagara::chart
