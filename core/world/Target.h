#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/Planar.h"
#include "core/base/Units.h"
#include "core/world/Activity.h"

namespace sagara::core {

/// What kind of vessel a target is: how she looks and behaves.
enum class TargetType : std::uint8_t { Fishing, Coaster, Tanker, Container, Ferry, Yacht, Tug, FastCraft };

enum class TargetBehaviour : std::uint8_t {
    Route,    ///< follows her waypoints once, then lies stopped at the last
    Circuit,  ///< follows her waypoints for ever
    Lying,    ///< stopped or anchored where she is
    Hostile,  ///< loiters at her first waypoint, closes an own ship that comes near, harasses her
    Course    ///< keeps the heading and speed she begins with
};
inline constexpr TargetType kLastTargetType = TargetType::FastCraft;
inline constexpr TargetBehaviour kLastTargetBehaviour = TargetBehaviour::Course;

/// A traffic ship of the scenario, or one that the trainer has added (State::added). Immutable; positions in
/// frame N.
struct TargetLayout {
    std::string id;
    std::string name;
    TargetType type = TargetType::Fishing;
    TargetBehaviour behaviour = TargetBehaviour::Route;
    Activity activity = Activity::UnderWay;
    double length_m = 10.0;
    double beam_m = 3.0;
    double draught_m = 1.0;
    struct Waypoint {
        NorthEast position;
        double speed_mps = 0.0;  ///< on the way to it; at the first: where she keeps her course

        template <typename Archive, typename Self>
        static void fields(Archive& ar, Self& self) {
            ar(self.position, self.speed_mps);
        }
        friend bool operator==(const Waypoint&, const Waypoint&) = default;
    };
    std::vector<Waypoint> route;  ///< the first is where she starts
    double heading_rad = 0.0;     ///< at her start, unless a second waypoint says where she goes
    int fromLevel = 1;            ///< appears from this difficulty on
    bool onEvent = false;         ///< appears only when an event says so
    std::vector<BodyPoint> outline;
    std::string picture;  ///< id of a picture document; empty: drawn by her type

    double mass_kg() const;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.id, self.name, self.type, self.behaviour, self.activity, self.length_m, self.beam_m,
           self.draught_m, self.route, self.heading_rad, self.fromLevel, self.onEvent, self.outline,
           self.picture);
    }
    friend bool operator==(const TargetLayout&, const TargetLayout&) = default;
};
inline constexpr double kFastestTarget_mps = 60.0 * kKnot_mps;
inline constexpr std::size_t kLongestTargetRoute = 64;  ///< points that an order gives at most
/// Whether a layout that did not come from a document can sail: all values finite and within what a document
/// may say, a route, an outline.
bool isSound(const TargetLayout& layout);

/// What a hostile craft is doing.
enum class HostilePhase : std::uint8_t { Loiter, Close, Harass, Withdraw };

struct TargetState {
    bool present = false;
    bool stopped = false;  ///< after a collision, or by order: dead in the water
    NorthEast position;
    double heading_rad = 0.0;
    double speed_mps = 0.0;
    double yawRate_radps = 0.0;
    std::uint32_t leg = 0;           ///< waypoint she heads for
    double orderedSpeed_mps = -1.0;  ///< by the instructor; negative: as her route says
    bool steered = false;            ///< by the instructor: she keeps orderedHeading_rad
    double orderedHeading_rad = 0.0;
    std::vector<TargetLayout::Waypoint> orderedRoute;  ///< by the instructor; empty: her own
    std::uint32_t orderedLeg = 0;                      ///< point of it she heads for
    NorthEast home;  ///< where a hostile craft loiters: her first waypoint, or where she was put
    HostilePhase phase = HostilePhase::Loiter;
    double phaseTime_s = 0.0;

    NorthEast velocity() const { return speed_mps * unitVector(heading_rad); }

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.present, self.stopped, self.position, self.heading_rad, self.speed_mps, self.yawRate_radps,
           self.leg, self.orderedSpeed_mps, self.steered, self.orderedHeading_rad, self.orderedRoute,
           self.orderedLeg, self.home, self.phase, self.phaseTime_s);
    }
    bool underOrders() const { return steered || !orderedRoute.empty(); }
};

/// What she is taken to do when the scenario does not say: lying ships are at anchor, yachts sail.
Activity usualActivity(TargetType type, TargetBehaviour behaviour);
/// What she is doing now. Stopped after a collision or by order she is not under command, unless she lay at
/// anchor or alongside: not under command is who is under way (rule 3).
Activity activityNow(const TargetLayout& layout, const TargetState& state);

/// She at her start, heading along her first leg at its speed, not yet present.
TargetState startOf(const TargetLayout& layout);

/// Where she wants to go and how fast, for this tick.
struct TargetIntent {
    double heading_rad;
    double speed_mps;
};
TargetIntent followRoute(const TargetLayout& layout, TargetState& state);
/// What the trainer has ordered: a heading, or a route that she follows once. With `underOrders` only.
TargetIntent followOrders(const TargetLayout& layout, TargetState& state);
/// Forgets what the trainer has ordered: she goes on with what she did of herself.
void resumeOwn(TargetState& state);

/// First-order dynamics in yaw and speed with limits by length and speed (after Nomoto 1957): no jumps in
/// heading, turn rate or speed. Turning circle 2.5 lengths in radius at any speed, 1.5 for fast craft.
void moveTarget(const TargetLayout& layout, TargetState& state, const TargetIntent& intent, NorthEast current,
                double dt_s);

const char* targetTypeName(TargetType type);

}  // namespace sagara::core
