#include "ui/hints/Hints.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using core::NorthEast;

constexpr double kLookAhead_m = core::kNauticalMile_m, kLookEvery_m = 20.0;
constexpr double kAtWaypoint_m = 50.0;       ///< nearer to the first one, the next is named
constexpr double kLeastApproach_mps = 0.25;  ///< half a knot

std::optional<double> limitAt(const core::World& world, NorthEast place, const core::RouteProgress& route) {
    core::Observation there;
    there.position = place;
    double limit_mps = core::limitsAt(world.mission, there, route).speedOverGround_mps;
    const auto& waypoints = world.route.waypoints;
    // A rubric without speeds leaves those of the route.
    if (limit_mps == 0.0 && route.leg < waypoints.size()) limit_mps = waypoints[route.leg].speedMax_mps;
    return limit_mps > 0.0 ? std::optional(limit_mps) : std::nullopt;
}

std::optional<Hints::Task> taskOf(const core::World& world, const core::Snapshot& now) {
    const std::size_t count = std::min(now.tasks.size(), world.mission.tasks.size());
    for (std::size_t i = 0; i < count; ++i)
        if (!now.tasks[i].done) return Hints::Task{i + 1, count, world.mission.tasks[i]->title()};
    return std::nullopt;
}

std::optional<Hints::Waypoint> waypointOf(const core::World& world, const core::OwnShipView& ship,
                                          const core::RouteProgress& route) {
    const auto& all = world.route.waypoints;
    const NorthEast here = ship.motion.position();
    if (all.size() < 2 || route.along_m > world.path.length_m() - 1.0) return std::nullopt;
    const bool before = route.along_m <= 0.0 && core::distance(here, all[0].position) > kAtWaypoint_m;
    const std::size_t index = before ? 0 : std::min<std::size_t>(route.leg, all.size() - 1);
    const double bearing_rad = core::bearing_rad(here, all[index].position);
    Hints::Waypoint next;
    next.index = index;
    next.name = all[index].name;
    next.bearing_rad = core::wrapTwoPi(bearing_rad - world.area.frame.convergence_rad(here));
    next.distance_m = core::distance(here, all[index].position);
    const double nearer_mps = core::dot(ship.overGround_mps, core::unitVector(bearing_rad));
    if (nearer_mps > kLeastApproach_mps) next.time_s = next.distance_m / nearer_mps;
    return next;
}

std::optional<Hints::SpeedAhead> aheadOf(const core::World& world, double limit_mps,
                                         const core::RouteProgress& route) {
    const double end_m = std::min(world.path.length_m(), route.along_m + kLookAhead_m);
    for (double along_m = route.along_m + kLookEvery_m; along_m < end_m; along_m += kLookEvery_m) {
        const core::RoutePath::Place place = world.path.at(along_m);
        const auto there = limitAt(world, world.path.pointAt(along_m),
                                   {along_m, 0.0, static_cast<std::uint32_t>(place.leg)});
        if (there && *there < limit_mps) return Hints::SpeedAhead{*there, along_m - route.along_m};
    }
    return std::nullopt;
}

std::optional<Hints::OffTrack> trackOf(const core::World& world, const core::RouteProgress& route) {
    const auto& all = world.route.waypoints;
    if (all.size() < 2 || route.leg >= all.size()) return std::nullopt;
    const auto& leg = all[route.leg];
    return Hints::OffTrack{route.offTrack_m, route.offTrack_m < 0.0 ? leg.portLimit_m : leg.starboardLimit_m};
}

}  // namespace

bool Hints::OffTrack::outside() const { return std::abs(off_m) > limit_m; }

Hints hintsFor(const core::World& world, const core::Snapshot& now, const core::RouteProgress& route) {
    Hints hints;
    hints.task = taskOf(world, now);
    hints.allDone = !hints.task && !world.mission.tasks.empty();
    if (now.ships.empty()) return hints;
    hints.waypoint = waypointOf(world, now.ships[0], route);
    hints.speedLimit_mps = limitAt(world, now.ships[0].motion.position(), route);
    if (world.path.length_m() == 0.0) return hints;
    hints.track = trackOf(world, route);
    hints.ahead = aheadOf(world, hints.speedLimit_mps.value_or(1e9), route);
    return hints;
}

Hints hintsFor(const core::World& world, const core::Snapshot& now) {
    core::RouteProgress route;
    if (!now.ships.empty() && world.path.length_m() > 0.0) {
        const auto place =
            world.path.nearest(now.ships[0].motion.position(), 0.0, 0.0, world.path.length_m());
        route = {place.along_m, place.offTrack_m, static_cast<std::uint32_t>(place.leg)};
    }
    return hintsFor(world, now, route);
}

}  // namespace sagara::ui
