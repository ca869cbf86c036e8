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

inline RouteShape routeShape(const core::Route& route, const core::RoutePath& path, double step_m) {
    if (path.length_m() <= 0.0) return {step_m, {}, {}, {}};
    RouteShape shape{step_m, chart::corridorPieces(route, path, step_m), {}, chart::pathLine(path, step_m)};
    for (const double side : {-1.0, 1.0}) {
        for (auto& edge : chart::corridorEdge(route, path, side, step_m))
            shape.edges.push_back(std::move(edge));
    }
    return shape;
}

}  // namespace sagara::ui
