#include "ui/widgets/RouteShape.h"

#include <cmath>

#include "ui/chart/Polyline.h"

namespace sagara::ui {
namespace {

constexpr double kFine = 1.0 / 40.0;  ///< of a step: what may be left out

/// Whether b lies on the line from a to c, so nearly that nobody sees it.
bool straight(core::NorthEast a, core::NorthEast b, core::NorthEast c, double tolerance_m) {
    const core::NorthEast chord = c - a;
    return std::abs(core::cross(chord, b - a)) <= tolerance_m * core::length(chord);
}

std::vector<chart::CorridorPiece> joined(const std::vector<chart::CorridorPiece>& pieces,
                                         double tolerance_m) {
    std::vector<chart::CorridorPiece> made;
    for (const chart::CorridorPiece& piece : pieces) {
        const auto& [portFrom, portTo, starboardTo, starboardFrom] = piece.corners;
        if (!made.empty()) {
            auto& last = made.back().corners;
            const bool goesOn = core::distance(last[1], portFrom) < 0.01 &&
                                core::distance(last[2], starboardFrom) < 0.01 &&
                                straight(last[0], portFrom, portTo, tolerance_m) &&
                                straight(last[3], starboardFrom, starboardTo, tolerance_m);
            if (goesOn) {
                last[1] = portTo;
                last[2] = starboardTo;
                continue;
            }
        }
        made.push_back(piece);
    }
    return made;
}

}  // namespace

RouteShape routeShape(const core::Route& route, const core::RoutePath& path, double step_m) {
    if (path.length_m() <= 0.0) return {step_m, {}, {}, {}};
    const double fine_m = kFine * step_m;
    RouteShape shape{step_m,
                     joined(chart::corridorPieces(route, path, step_m), 0.25 * fine_m),
                     {},
                     chart::simplified(chart::pathLine(path, step_m), fine_m)};
    for (const double side : {-1.0, 1.0}) {
        for (const auto& edge : chart::corridorEdge(route, path, side, step_m))
            shape.edges.push_back(chart::simplified(edge, fine_m));
    }
    return shape;
}

}  // namespace sagara::ui
