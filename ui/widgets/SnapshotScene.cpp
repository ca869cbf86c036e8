#include "ui/widgets/SnapshotScene.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {
namespace {

double swing_m(const core::Area& area, const core::OwnShip& ship, const core::AnchorGear& gear,
               const core::AnchorState& anchor, double tide_m) {
    const double up_m = std::max(0.0, area.depth_m(anchor.position) + tide_m + gear.hawseHeight_m);
    const double level_m = std::sqrt(std::max(0.0, anchor.cableOut_m * anchor.cableOut_m - up_m * up_m));
    return level_m + gear.hawse.x_m + 0.5 * ship.vessel.hull.lengthOverall_m;
}

ChartZone zoneOf(const core::TaskZone& zone, const std::string& name, ChartZone::Kind kind, int id) {
    ChartZone made;
    made.id = id;
    made.name = QString::fromStdString(name);
    made.kind = kind;
    if (zone.kind == core::TaskZone::Kind::Circle) {
        made.centre = zone.points.front();
        made.radius_m = zone.radius_m;
    } else {
        made.corners = zone.points;
    }
    return made;
}

}  // namespace

std::vector<ChartZone> zonesOf(const core::Mission& mission, const std::vector<core::TaskView>& tasks) {
    std::vector<ChartZone> zones;
    const auto next = [&] { return static_cast<int>(zones.size()); };
    for (std::size_t i = 0; i < mission.tasks.size(); ++i) {
        const auto zone = mission.tasks[i]->zone();
        const bool done = i < tasks.size() && tasks[i].done;
        if (zone)
            zones.push_back(zoneOf(*zone, mission.tasks[i]->title(),
                                   done ? ChartZone::Kind::Done : ChartZone::Kind::Task, next()));
    }
    for (const auto& criterion : mission.criteria) {
        for (const core::TaskZone& zone : criterion->zones())
            zones.push_back(zoneOf(zone, criterion->terms().title, ChartZone::Kind::Limit, next()));
    }
    return zones;
}

std::vector<ChartShip> ownShipsOf(const core::World& world, const core::Snapshot& now) {
    std::vector<ChartShip> ships;
    for (std::size_t i = 0; i < now.ships.size(); ++i) {
        const core::OwnShip& ship = *world.ships[i];
        ships.push_back({static_cast<int>(i), QString::fromStdString(ship.name),
                         now.ships[i].motion.position(), now.ships[i].motion.heading_rad,
                         now.ships[i].overGround_mps, ship.vessel.hull.lengthOverall_m,
                         ship.vessel.hull.beam_m, false});
    }
    return ships;
}

std::vector<ChartShip> targetsOf(const core::World& world, const core::Snapshot& now) {
    std::vector<ChartShip> ships;
    for (const core::TargetView& target : now.targets) {
        const core::TargetLayout& layout = core::targetLayout(world, now, target.index);
        ships.push_back({static_cast<int>(target.index), QString::fromStdString(layout.name), target.position,
                         target.heading_rad, target.speed_mps * core::unitVector(target.heading_rad),
                         layout.length_m, layout.beam_m, layout.behaviour == core::TargetBehaviour::Hostile});
    }
    return ships;
}

std::vector<ChartAnchor> anchorsOf(const core::World& world, const core::Snapshot& now) {
    std::vector<ChartAnchor> anchors;
    for (std::size_t i = 0; i < now.ships.size(); ++i) {
        const auto& gear = world.ships[i]->vessel.groundTackle.anchors;
        for (std::size_t k = 0; k < gear.size() && k < now.ships[i].anchors.size(); ++k) {
            const core::AnchorState& anchor = now.ships[i].anchors[k];
            if (!anchor.onBottom) continue;
            const QString cable = chart::number(anchor.cableOut_m / core::kShackle_m, 1);
            anchors.push_back({tr("%1 anchor, %2 shackles").arg(QString::fromStdString(gear[k].id), cable),
                               anchor.position,
                               swing_m(world.area, *world.ships[i], gear[k], anchor, now.tide_m)});
        }
    }
    return anchors;
}

ChartPrediction predictionOf(const core::World& world, std::size_t ship,
                             const std::vector<core::PredictedPose>& poses) {
    ChartPrediction made;
    made.length_m = world.ships[ship]->vessel.hull.lengthOverall_m;
    made.beam_m = world.ships[ship]->vessel.hull.beam_m;
    for (const core::PredictedPose& pose : poses)
        made.poses.push_back({pose.time.seconds(), pose.position, pose.heading_rad});
    return made;
}

}  // namespace sagara::ui
