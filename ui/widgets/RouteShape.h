#pragma once

#include <vector>

#include "ui/chart/Corridor.h"

namespace sagara::ui {

/// A route and its corridor as lines in frame N, fine enough for one scale. Worked out once, drawn often.
struct RouteShape {
    double step_m = 0.0;
    std::vector<chart::CorridorPiece> band;
    std::vector<std::vector<core::NorthEast>> edges;
    std::vector<core::NorthEast> line;
};

/// `step_m`: no more than a few pixels. Straights become one piece.
RouteShape routeShape(const core::Route& route, const core::RoutePath& path, double step_m);

}  // namespace sagara::ui
