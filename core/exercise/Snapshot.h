#pragma once

#include <optional>
#include <vector>

#include "core/assess/Observation.h"
#include "core/exercise/State.h"

namespace sagara::core {

/// Blades, azimuth drive and engine of one shaft, as far as she has them.
struct DriveView {
    double pitch = 1.0;       ///< over the design pitch
    double pitchOrder = 1.0;  ///< of lever or hand
    bool pitchByHand = false;
    double azimuth_rad = 0.0;
    double azimuthOrder_rad = 0.0;     ///< by hand; the wheel comes on top of it
    std::optional<double> torque_Nm;   ///< into the propeller, where it is known
    std::optional<double> startsLeft;  ///< of the starting air
};

/// One own ship as observers may see her.
struct OwnShipView {
    ShipMotion motion;
    NorthEast overGround_mps;
    double rudder_rad = 0.0;
    double rudderOrder_rad = 0.0;
    std::vector<double> shafts_rps;
    std::vector<double> shaftOrders_rps;
    std::vector<DriveView> drives;         ///< as shafts_rps
    std::vector<ThrusterState> thrusters;  ///< bow to stern as in her document
    AutopilotState autopilot;
    bool pilotEngaged = false;
    std::vector<LineState> lines;
    std::vector<AnchorState> anchors;
    double underKeel_m = 0.0;
    bool aground = false;
    bool notUnderCommand = false;  ///< by a fault: no rudder that answers, or no engine
    std::uint8_t pumpsFailed = 0;  ///< of the two of the steering gear
    bool rudderJammed = false;
    std::vector<bool> enginesFailed;         ///< as shafts_rps
    std::uint8_t freeMotions = kAllMotions;  ///< others are held, see FreezeMotionOrder
};
/// What she is doing as others see it. Not under command is who is neither at anchor nor alongside.
Activity activityOf(const OwnShipView& ship);

/// One traffic ship that is there. She rides the long waves like a cork of her length.
struct TargetView {
    std::size_t index = 0;  ///< in State::targets: see targetLayout
    NorthEast position;
    double down_m = 0.0;
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    double heading_rad = 0.0;
    double speed_mps = 0.0;
    double yawRate_radps = 0.0;
    Activity activity = Activity::UnderWay;
};

struct TaskView {
    bool done = false;
    SimTime doneAt;
};

/// What may be seen of a running exercise at one tick. Immutable once made; shared by all observers.
struct Snapshot {
    std::int64_t tick = 0;
    int level = 1;
    std::vector<OwnShipView> ships;
    std::vector<TargetView> targets;
    std::vector<TargetLayout> added;  ///< as State::added, also those that are not there
    Weather weather;
    WindVelocity wind;    ///< with its gusts, at this moment
    SeaState sea;         ///< with World::waves all there is to draw
    double tide_m = 0.0;  ///< above chart datum
    std::vector<TaskView> tasks;
    double score = 100.0;
    bool failed = false;
    bool finished = false;

    SimTime time() const { return timeOfTick(tick); }
};

/// What is known of a target that is seen: index as in TargetView.
inline const TargetLayout& targetLayout(const World& world, const Snapshot& snapshot, std::size_t index) {
    return targetLayout(world, snapshot.added, index);
}

Snapshot view(const World& world, const State& state);

}  // namespace sagara::core
