#include "ui/demo/DemoCameras.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using core::NorthEast;

constexpr double kShoreFarthest_m = 1.6 * core::kNauticalMile_m;
constexpr double kTargetFarthest_m = 0.8 * core::kNauticalMile_m, kTargetNearest_m = 60.0;
constexpr double kEyeOnShore_m = 14.0, kEyeOnShip_m = 8.0;
constexpr double kShownAcross = 0.35;  ///< of the picture, by her length
constexpr double kMostGlasses = 6.0;
constexpr double kUnderBand_rad = 0.06;  ///< looks down so far: the captions hide the foot of the picture

bool standsOnShore(const core::Place& place) {
    constexpr std::array<const char*, 4> kinds{"lighthouse", "breakwater_head", "headland", "fort"};
    return std::any_of(kinds.begin(), kinds.end(), [&](const char* kind) { return place.kind == kind; });
}

double sight_m(const render::Moment& moment) { return 0.7 * moment.weather.visibility_m; }

/// She shall fill a good part of the picture, whatever the distance.
double glassesFor(double distance_m, double length_m) {
    const double naked = length_m / std::max(1.0, distance_m) / kViewportFov_rad;
    return std::clamp(kShownAcross / naked, 1.0, kMostGlasses);
}

void lookFrom(CameraRig& rig, NorthEast from, double up_m, const core::World& world,
              const render::Moment& moment) {
    rig.kind = CameraKind::Shore;
    rig.shore = from;
    rig.shoreUp_m = up_m;
    const double distance_m = core::distance(from, moment.ships[0].position);
    rig.magnify(glassesFor(distance_m, world.ships[0]->vessel.hull.lengthOverall_m));
    rig.turn(0.0, -kUnderBand_rad / rig.magnification());
}

double ground_m(const core::Area& area, NorthEast place) {
    for (const core::Grid& grid : area.elevation)
        if (grid.covers(place)) return std::max(0.0, grid.at(place));
    return 0.0;
}

}  // namespace

std::optional<std::size_t> shoreFor(const core::World& world, const render::Moment& moment) {
    if (moment.ships.empty()) return std::nullopt;
    std::optional<std::size_t> best;
    double nearest_m = std::min(kShoreFarthest_m, sight_m(moment));
    for (std::size_t i = 0; i < world.area.places.size(); ++i) {
        const core::Place& place = world.area.places[i];
        const double distance_m = core::distance(place.position, moment.ships[0].position);
        if (!standsOnShore(place) || distance_m >= nearest_m || distance_m < 80.0) continue;
        nearest_m = distance_m;
        best = i;
    }
    return best;
}

std::optional<std::size_t> targetFor(const core::World& world, const render::Moment& moment) {
    if (moment.ships.empty()) return std::nullopt;
    std::optional<std::size_t> best;
    double nearest_m = std::min(kTargetFarthest_m, sight_m(moment));
    for (const render::TargetPose& target : moment.targets) {
        const double distance_m = core::distance(target.position, moment.ships[0].position);
        if (target.index >= world.targets.size() || distance_m >= nearest_m || distance_m < kTargetNearest_m)
            continue;
        nearest_m = distance_m;
        best = target.index;
    }
    return best;
}

DemoCamera nextDemoCamera(const DemoCamera& now, const core::World& world, const render::Moment& moment) {
    constexpr int kKinds = 5;
    for (int step = 1; step <= kKinds; ++step) {
        const auto kind = static_cast<DemoCameraKind>((static_cast<int>(now.kind) + step) % kKinds);
        switch (kind) {
            case DemoCameraKind::Bridge:
            case DemoCameraKind::Chase:
                return {kind};
            case DemoCameraKind::Wing:
                return {kind, 0, !now.port};
            case DemoCameraKind::Shore:
                if (const auto place = shoreFor(world, moment)) return {kind, *place, now.port};
                break;
            case DemoCameraKind::Target:
                if (const auto target = targetFor(world, moment)) return {kind, *target, now.port};
                break;
        }
    }
    return {};
}

void aim(CameraRig& rig, const DemoCamera& camera, const core::World& world, const render::Moment& moment) {
    rig.lookAhead();
    switch (camera.kind) {
        case DemoCameraKind::Bridge:
            rig.kind = CameraKind::Bridge;
            return;
        case DemoCameraKind::Chase:
            rig.kind = CameraKind::Chase;
            rig.turn(0.35, -kUnderBand_rad);  // a little from the side: she shows her length
            return;
        case DemoCameraKind::Wing:
            rig.kind = camera.port ? CameraKind::WingPort : CameraKind::WingStarboard;
            return;
        case DemoCameraKind::Shore:
            if (moment.ships.empty() || camera.index >= world.area.places.size()) break;
            return lookFrom(rig, world.area.places[camera.index].position,
                            kEyeOnShore_m + ground_m(world.area, world.area.places[camera.index].position),
                            world, moment);
        case DemoCameraKind::Target:
            for (const render::TargetPose& target : moment.targets)
                if (target.index == camera.index && !moment.ships.empty())
                    return lookFrom(rig, target.position, kEyeOnShip_m - target.down_m, world, moment);
            break;
    }
    rig.kind = CameraKind::Chase;  // what it looked from has gone
}

}  // namespace sagara::ui
