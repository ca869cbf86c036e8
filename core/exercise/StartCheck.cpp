#include "core/exercise/StartCheck.h"

#include <cmath>
#include <cstdio>

namespace sagara::core {
namespace {

std::string metres(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f m", value);
    return text;
}

/// Two outlines: do any of their corners lie in the other?
bool overlap(const std::vector<BodyPoint>& a, const HeadingFrame& frameA, const std::vector<BodyPoint>& b,
             const HeadingFrame& frameB) {
    const auto cornersInside = [](const auto& corners, const HeadingFrame& from, const auto& outline,
                                  const HeadingFrame& to) {
        std::vector<NorthEast> ring;
        for (const BodyPoint& p : outline) ring.push_back({p.x_m, p.y_m});
        for (const BodyPoint& corner : corners) {
            const BodyPoint p = to.pointInBody(from.point(corner));
            if (contains(ring, {p.x_m, p.y_m})) return true;
        }
        return false;
    };
    return cornersInside(a, frameA, b, frameB) || cornersInside(b, frameB, a, frameA);
}

bool onLand(const Area& area, const OwnShip& ship, const HeadingFrame& frame) {
    for (const BodyPoint& p : ship.hull.outline) {
        if (area.isLand(frame.point(p))) return true;
    }
    return false;
}

}  // namespace

void checkStart(const World& world, config::Reader& scenario) {
    for (std::size_t i = 0; i < world.ships.size(); ++i) {
        const OwnShip& ship = *world.ships[i];
        const std::string path = "ownShips[" + std::to_string(i) + "]";
        const HeadingFrame frame(ship.start.position(), ship.start.heading_rad);
        if (onLand(world.area, ship, frame))
            scenario.problem(path, "starts on land", "a place with all of her afloat");
        const double clearance_m =
            underKeel(world.area, ship.keel, ship.start, world.tide.height_m({})).clearance_m;
        if (clearance_m < 0.0) {
            scenario.problem(path, "starts aground, under-keel clearance " + metres(clearance_m),
                             "water under her keel");
        }
        for (std::size_t j = 0; j < i; ++j) {
            const OwnShip& other = *world.ships[j];
            if (!overlap(ship.hull.outline, frame, other.hull.outline,
                         {other.start.position(), other.start.heading_rad}))
                continue;
            scenario.problem(path, "starts in ownShips[" + std::to_string(j) + "]", "ships apart");
        }
        for (std::size_t j = 0; j < world.targets.size(); ++j) {
            const TargetLayout& target = world.targets[j];
            if (target.route.empty()) continue;
            const TargetState start = startOf(target);
            if (!overlap(ship.hull.outline, frame, target.outline, {start.position, start.heading_rad}))
                continue;
            scenario.problem("traffic[" + std::to_string(j) + "]", "starts in " + path, "ships apart");
        }
    }
}

}  // namespace sagara::core
