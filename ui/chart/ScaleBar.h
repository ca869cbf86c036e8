#pragma once

namespace sagara::chart {

/// Length of one part of a scale bar in cables: 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5 ... the longest that is not
/// longer than `longest_m`, else the shortest.
double scaleBarPart_cables(double longest_m);

}  // namespace sagara::chart
