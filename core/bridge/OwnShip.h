#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/bridge/Autopilot.h"
#include "core/bridge/ShaftControl.h"
#include "core/bridge/SteeringGear.h"
#include "core/bridge/ThrusterControl.h"
#include "core/motion/Bow.h"
#include "core/motion/ShipDynamics.h"
#include "core/world/Anchor.h"
#include "core/world/Contact.h"
#include "core/world/MooringLine.h"
#include "core/world/UnderKeel.h"

namespace sagara::core {

/// How she answers small rudder, after Nomoto (1957), in ship lengths run: r' = K' delta after a lag of T'.
struct TurningIndices {
    double gain = 1.0;  ///< K', r L/U per rudder
    double lag = 1.0;   ///< T', in L/U
};

/// An own ship of the exercise: her vessel and where she begins. Immutable, part of the World.
struct OwnShip {
    /// `seaHull`: see ShipDynamics.
    OwnShip(std::string shipId, std::string shipName, Vessel shipVessel, std::string_view model = {},
            std::shared_ptr<const SeaHull> seaHull = nullptr);

    std::string id;
    std::string name;
    Vessel vessel;
    std::vector<Propeller> propellers;  ///< as propulsion.units
    ShipDynamics dynamics;
    ContactHull hull;
    Bow bow;
    Keel keel;
    ShipMotion start;
    std::array<double, kMostShafts> startShafts_rps{};
    bool modelFeelsDepth;    ///< her manoeuvring model has effects of shallow water of its own
    double advancePerRev_m;  ///< steady speed ahead in calm water over shaft speed, from a run of the model
    TurningIndices turning;  ///< half ahead, from a run of the model
    std::vector<std::string> lineIds;
    std::vector<LineLayout> lines;  ///< made fast at the start

    std::size_t shaftCount() const { return vessel.propulsion.units.size(); }
    std::size_t thrusterCount() const { return vessel.thrusters.units.size(); }
    std::size_t anchorCount() const { return vessel.groundTackle.anchors.size(); }
};

/// What the scripted pilot remembers; see Pilot.h.
struct PilotMemory {
    bool engaged = false;
    std::uint32_t step = 0;
    std::uint32_t phase = 0;  ///< within the step
    double since_s = 0.0;     ///< time in the phase
    double noteA = 0.0;       ///< the step's own: see Pilot.cpp
    double noteB = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.engaged, self.step, self.phase, self.since_s, self.noteA, self.noteB);
    }
};

/// Whether something of a kind is being touched and when it last was.
struct ContactMemory {
    bool touching = false;
    std::int64_t lastTick = -1'000'000;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.touching, self.lastTick);
    }
};

/// What is remembered of the sea at the bow.
struct BowMemory {
    double forefootRise_m = 0.0;  ///< when it was looked at last
    std::int64_t greenTick = -1'000'000;
    std::int64_t slamTick = -1'000'000;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.forefootRise_m, self.greenTick, self.slamTick);
    }
};

/// Which of her six motions an own ship is free to make, for the classroom: one bit each. The others are
/// held: no velocity in them through the water, attitude and heave as they were.
enum class FreeMotion : std::uint8_t { Surge = 1, Sway = 2, Heave = 4, Roll = 8, Pitch = 16, Yaw = 32 };
inline constexpr std::uint8_t kAllMotions = 63;
inline bool isFree(std::uint8_t motions, FreeMotion motion) {
    return (motions & static_cast<std::uint8_t>(motion)) != 0;
}
/// Takes what is held out of velocities, or out of their rates: only the six velocities are touched.
void holdMotions(std::uint8_t free, ShipMotion& velocities);

/// Everything about an own ship that changes. Part of State.
struct OwnShipState {
    ShipMotion motion;
    MemoryState water{};  ///< what it remembers of her motions
    SteeringGearState steering;
    ShaftStates shafts;
    std::array<ThrusterState, kMostThrusters> thrusters;
    AutopilotState autopilot;
    PilotMemory pilot;
    std::array<LineState, kMostLines> lines;
    std::array<AnchorState, kMostAnchors> anchors;
    std::array<ContactMemory, kContactKinds> contacts;
    NorthEast shownOverGround_mps;  ///< velocity over the ground as the GPS shows it: mean of the last
                                    ///< quarter minute
    bool aground = false;
    double underKeel_m = 0.0;
    std::uint8_t freeMotions = kAllMotions;
    BowMemory bow;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.motion, self.water, self.steering, self.shafts, self.thrusters, self.autopilot, self.pilot,
           self.lines, self.anchors, self.contacts, self.shownOverGround_mps, self.aground, self.underKeel_m,
           self.freeMotions, self.bow);
    }
};

OwnShipState startOf(const OwnShip& ship);

/// Rudder, shafts and thrusters as they are.
Actuators actuatorsOf(const OwnShip& ship, const OwnShipState& state);
/// Steering gear, shafts and thrusters for one tick; what the hull feels in it.
Actuators runMachinery(const OwnShip& ship, OwnShipState& state, double dt_s);

}  // namespace sagara::core
