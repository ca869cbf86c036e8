#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/motion/Actuators.h"
#include "core/vessel/Machinery.h"
#include "core/world/SpeedZone.h"

/// How the scripted pilot sails a lesson: steps, one after the other. Part of the scenario document.
/// Immutable.
namespace sagara::core {

/// "lines": orders to lines, then waits until those let go are off their bollards and `wait_s` have passed.
struct LinesStep {
    std::uint8_t letGo = 0;  ///< bit masks
    std::uint8_t slack = 0;
    std::uint8_t heave = 0;
    std::uint8_t hold = 0;
    double wait_s = 0.0;
};

/// "run": rudder and shafts held until one of the conditions given is met.
struct RunStep {
    double rudder_rad = 0.0;
    std::array<double, kMostShafts> shafts_rps{};
    std::optional<double> headingChange_rad;  ///< turned this much from where the step began
    std::optional<double> moved_m;            ///< run this far through the water since the step began
    std::optional<double> slowerThan_mps;     ///< through the water
    double atMost_s = 0.0;                    ///< in any case
};

/// "turn": on the spot to a heading, screws opposed (with one screw: kicks ahead).
struct TurnStep {
    double heading_rad = 0.0;
    double shaft_rps = 0.0;
};

/// "track": along the route until a waypoint is passed, or a place is near, at the speeds of the zones.
struct TrackStep {
    std::vector<SpeedZone> speeds;
    double cruise_mps = 0.0;  ///< outside all zones
    double untilAlong_m = 0.0;
};

/// "anchor": up to the place on the last course of the route, stop, sternway, let go, veer, bring up.
struct AnchorStep {
    NorthEast place;
    std::uint8_t anchor = 0;
    double firstCable_m = 0.0;  ///< brake on here at let go
    double cable_m = 0.0;       ///< veered to in the end
    double approach_mps = 0.0;
};

using PilotStep = std::variant<LinesStep, RunStep, TurnStep, TrackStep, AnchorStep>;
using PilotScript = std::vector<PilotStep>;

}  // namespace sagara::core
