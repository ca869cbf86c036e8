#pragma once

#include <cstdint>

#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"
#include "core/world/Route.h"

namespace sagara::core {

struct OwnShip;

enum class AutopilotMode : std::uint8_t { Off, Heading, Track };
/// The ship may be anywhere along the route: the nearest point of all of it is taken.
inline constexpr double kSomewhere_m = -1.0;

struct AutopilotState {
    AutopilotMode mode = AutopilotMode::Off;
    double setHeading_rad = 0.0;
    double along_m = 0.0;         ///< place on the route, track mode; kSomewhere_m: not yet looked for
    double offTrackSum_ms = 0.0;  ///< integral of the cross-track error, against wind and current
    double yawRate_radps = 0.0;   ///< of the ship, the swing of the waves smoothed out

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.mode, self.setHeading_rad, self.along_m, self.offTrackSum_ms, self.yawRate_radps);
    }
};

/// Rudder for a heading: proportional with rate feedback, gains scaled by L/U. A ship that answers her rudder
/// late is checked the earlier, by her turning indices. `turn_radps`: wanted rate of turn, 0 on a straight
/// course.
double steerHeading_rad(const OwnShip& ship, const ShipMotion& m, double heading_rad, double turn_radps);

/// Rudder that keeps the ship on the path: course of the track a little ahead, turned towards the track by
/// line of sight, with the turn of the arc fed forward. A ship slow to answer looks farther ahead. Moves
/// state.along_m on.
double steerTrack_rad(const OwnShip& ship, const RoutePath& path, const ShipMotion& m, AutopilotState& state,
                      double dt_s);

/// One tick of whichever mode is on: the rudder order, or the given one when off.
double steerAutopilot_rad(const OwnShip& ship, const RoutePath& path, const ShipMotion& m,
                          AutopilotState& state, double handOrder_rad, double dt_s);

}  // namespace sagara::core
