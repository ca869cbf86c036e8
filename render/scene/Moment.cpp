#include "render/scene/Moment.h"

namespace sagara::render {
namespace {

OwnShipPose poseOf(const core::OwnShipView& ship) {
    OwnShipPose p;
    p.position = ship.motion.position();
    p.down_m = ship.motion.down_m;
    p.roll_rad = ship.motion.roll_rad;
    p.pitch_rad = ship.motion.pitch_rad;
    p.heading_rad = ship.motion.heading_rad;
    p.speedThroughWater_mps = ship.motion.surge_mps;
    p.yawRate_radps = ship.motion.yawRate_radps;
    p.rudder_rad = ship.rudder_rad;
    p.activity = core::activityOf(ship);
    p.lines = ship.lines;
    p.anchors = ship.anchors;
    return p;
}

TargetPose poseOf(const core::TargetView& target) {
    TargetPose p;
    p.position = target.position;
    p.down_m = target.down_m;
    p.roll_rad = target.roll_rad;
    p.pitch_rad = target.pitch_rad;
    p.heading_rad = target.heading_rad;
    p.speedThroughWater_mps = target.speed_mps;
    p.yawRate_radps = target.yawRate_radps;
    p.activity = target.activity;
    p.index = target.index;
    return p;
}

}  // namespace

Moment momentOf(const core::Snapshot& snapshot) {
    Moment m;
    m.time = snapshot.time();
    for (const core::OwnShipView& ship : snapshot.ships) m.ships.push_back(poseOf(ship));
    for (const core::TargetView& target : snapshot.targets) m.targets.push_back(poseOf(target));
    m.added = snapshot.added;
    m.weather = snapshot.weather;
    m.wind = snapshot.wind;
    m.sea = snapshot.sea;
    m.tide_m = snapshot.tide_m;
    return m;
}

}  // namespace sagara::render
