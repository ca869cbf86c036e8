#pragma once

#include <array>
#include <vector>

#include "core/world/Route.h"

namespace sagara::chart {

/// A short piece of the band that the cross-track limits leave on both sides of the path: port, port,
/// starboard, starboard.
struct CorridorPiece {
    std::array<core::NorthEast, 4> corners;
};

/// The band in pieces of about `step_m`, which follow the arcs of the path. Empty without a path.
std::vector<CorridorPiece> corridorPieces(const core::Route& route, const core::RoutePath& path,
                                          double step_m);

/// One edge of the band, in as many lines as it takes: broken where the limit changes, and in the inside of a
/// bend where the edge would cross itself. `side`: -1 port, +1 starboard.
std::vector<std::vector<core::NorthEast>> corridorEdge(const core::Route& route, const core::RoutePath& path,
                                                       double side, double step_m);

/// The path itself in steps.
std::vector<core::NorthEast> pathLine(const core::RoutePath& path, double step_m);

}  // namespace sagara::chart
