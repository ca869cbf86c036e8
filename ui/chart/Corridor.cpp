#include "ui/chart/Corridor.h"

#include <algorithm>
#include <cmath>

namespace sagara::chart {
namespace {

using core::NorthEast;

/// Number of equal steps not longer than `step_m`.
std::size_t stepsIn(double length_m, double step_m) {
    return static_cast<std::size_t>(std::clamp(std::ceil(length_m / std::max(step_m, 0.1)), 1.0, 4000.0));
}

/// A point beside the path: `off_m` to starboard.
NorthEast beside(const core::RoutePath::Place& here, NorthEast onPath, double off_m) {
    return onPath + off_m * core::turnedRight(core::unitVector(here.course_rad));
}

struct Leg {
    double from_m, to_m;
    double port_m, starboard_m;
};

std::vector<Leg> legsOf(const core::Route& route, const core::RoutePath& path) {
    std::vector<Leg> legs;
    if (path.length_m() <= 0.0) return legs;
    for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
        const core::Route::Waypoint& w = route.waypoints[i];
        const Leg leg{path.alongOf(i - 1), path.alongOf(i), w.portLimit_m, w.starboardLimit_m};
        if (leg.to_m > leg.from_m) legs.push_back(leg);
    }
    return legs;
}

CorridorPiece pieceBetween(const core::RoutePath& path, const Leg& leg, double from_m, double to_m) {
    const auto a = path.at(from_m), b = path.at(to_m);
    const NorthEast pa = path.pointAt(from_m), pb = path.pointAt(to_m);
    return {{beside(a, pa, -leg.port_m), beside(b, pb, -leg.port_m), beside(b, pb, leg.starboard_m),
             beside(a, pa, leg.starboard_m)}};
}

/// Whether a point of the edge is nearer to another part of the path than its limit: there the band has no
/// edge.
bool insideBand(const core::RoutePath& path, NorthEast p, double along_m, double limit_m) {
    const auto nearest = path.nearest(p, along_m, 4.0 * limit_m, 4.0 * limit_m);
    return std::abs(nearest.offTrack_m) < 0.98 * limit_m;
}

}  // namespace

std::vector<CorridorPiece> corridorPieces(const core::Route& route, const core::RoutePath& path,
                                          double step_m) {
    std::vector<CorridorPiece> pieces;
    for (const Leg& leg : legsOf(route, path)) {
        if (leg.port_m <= 0.0 && leg.starboard_m <= 0.0) continue;
        const std::size_t steps = stepsIn(leg.to_m - leg.from_m, step_m);
        const double each_m = (leg.to_m - leg.from_m) / static_cast<double>(steps);
        for (std::size_t k = 0; k < steps; ++k) {
            const double from_m = leg.from_m + each_m * static_cast<double>(k);
            pieces.push_back(pieceBetween(path, leg, from_m, from_m + each_m));
        }
    }
    return pieces;
}

std::vector<std::vector<NorthEast>> corridorEdge(const core::Route& route, const core::RoutePath& path,
                                                 double side, double step_m) {
    std::vector<std::vector<NorthEast>> lines;
    for (const Leg& leg : legsOf(route, path)) {
        const double limit_m = side < 0.0 ? leg.port_m : leg.starboard_m;
        const std::size_t steps = stepsIn(leg.to_m - leg.from_m, step_m);
        lines.emplace_back();
        for (std::size_t k = 0; k <= steps && limit_m > 0.0; ++k) {
            const double along_m =
                leg.from_m + (leg.to_m - leg.from_m) * static_cast<double>(k) / static_cast<double>(steps);
            const NorthEast p = beside(path.at(along_m), path.pointAt(along_m), side * limit_m);
            if (insideBand(path, p, along_m, limit_m)) {
                lines.emplace_back();
            } else {
                lines.back().push_back(p);
            }
        }
    }
    std::erase_if(lines, [](const std::vector<NorthEast>& line) { return line.size() < 2; });
    return lines;
}

std::vector<NorthEast> pathLine(const core::RoutePath& path, double step_m) {
    std::vector<NorthEast> line;
    if (path.length_m() <= 0.0) return line;
    const std::size_t steps = stepsIn(path.length_m(), step_m);
    for (std::size_t k = 0; k <= steps; ++k) {
        line.push_back(path.pointAt(path.length_m() * static_cast<double>(k) / static_cast<double>(steps)));
    }
    return line;
}

}  // namespace sagara::chart
