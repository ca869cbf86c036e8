#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/world/Target.h"

/// Orders of the trainer to traffic, beside TargetOrder. Places in frame N. What is out of range does
/// nothing.
namespace sagara::core {

/// A ship the scenario does not have. She gets the index after the last; at most kMostAddedTargets of them.
/// With a route she follows it from where she is; without one she keeps her course, or lies there when her
/// speed is 0; hostile ones loiter where they are put, and `speed_mps` is the fastest they go.
struct AddTargetOrder {
    std::string name;
    TargetType type = TargetType::Fishing;
    Activity activity = Activity::UnderWay;
    bool hostile = false;
    NorthEast position;
    double heading_rad = 0.0;
    double speed_mps = 0.0;
    double length_m = 12.0;
    double beam_m = 4.0;
    double draught_m = 1.5;
    std::vector<TargetLayout::Waypoint> route;  ///< where she goes from `position`

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.name, self.type, self.activity, self.hostile, self.position, self.heading_rad, self.speed_mps,
           self.length_m, self.beam_m, self.draught_m, self.route);
    }
};

/// Puts her somewhere else.
struct MoveTargetOrder {
    std::uint32_t target = 0;
    NorthEast position;
    double heading_rad = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.target, self.position, self.heading_rad);
    }
};

/// She turns to a heading and keeps it, at a speed, until TargetAction::Resume.
struct SteerTargetOrder {
    std::uint32_t target = 0;
    double heading_rad = 0.0;
    double speed_mps = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.target, self.heading_rad, self.speed_mps);
    }
};

/// She follows these points from where she is, each at its speed, and stops at the last; until
/// TargetAction::Resume.
struct RouteTargetOrder {
    std::uint32_t target = 0;
    std::vector<TargetLayout::Waypoint> points;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.target, self.points);
    }
};

struct State;
struct World;
/// True when it was done. The layout of an added target is State::added's last.
bool carryOut(const World& world, State& state, const AddTargetOrder& order);
bool carryOut(const World& world, State& state, const MoveTargetOrder& order);
bool carryOut(const World& world, State& state, const SteerTargetOrder& order);
bool carryOut(const World& world, State& state, const RouteTargetOrder& order);

}  // namespace sagara::core
