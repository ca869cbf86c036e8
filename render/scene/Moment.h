#pragma once

#include <cmath>
#include <vector>

#include "core/exercise/Snapshot.h"

namespace sagara::render {

/// Where a ship is and how she lies. Frame N; angles as in core::ShipMotion.
struct ShipPose {
    core::NorthEast position;
    double down_m = 0.0;
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    double heading_rad = 0.0;
    double speedThroughWater_mps = 0.0;  ///< ahead positive; makes bow wave and wake
    double yawRate_radps = 0.0;
    core::Activity activity = core::Activity::UnderWay;  ///< her lights and shapes

    bool makingWay() const { return std::abs(speedThroughWater_mps) > 0.25; }  ///< half a knot
};

struct OwnShipPose : ShipPose {
    double rudder_rad = 0.0;
    std::vector<core::LineState> lines;      ///< as World::ships' lines
    std::vector<core::AnchorState> anchors;  ///< as her ground tackle's
};

struct TargetPose : ShipPose {
    std::size_t index = 0;  ///< in World::targets, or beyond it in Moment::added
};

/// Everything about one instant that a picture shows, beside the World. Plain data: it crosses the link to
/// the channels, and the same moment gives the same picture everywhere.
struct Moment {
    core::SimTime time;
    std::vector<OwnShipPose> ships;         ///< as World::ships
    std::vector<TargetPose> targets;        ///< only those that are there
    std::vector<core::TargetLayout> added;  ///< by the trainer; their indices follow those of World::targets
    core::Weather weather;
    core::WindVelocity wind;
    core::SeaState sea;
    double tide_m = 0.0;  ///< above chart datum
};

Moment momentOf(const core::Snapshot& snapshot);

}  // namespace sagara::render
