#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/Planar.h"
#include "core/vessel/Provenance.h"

namespace sagara::core {

/// Steps of the engine telegraph, astern to ahead.
enum class TelegraphStep : std::uint8_t {
    FullAstern,
    HalfAstern,
    SlowAstern,
    DeadSlowAstern,
    Stop,
    DeadSlowAhead,
    SlowAhead,
    HalfAhead,
    FullAhead
};
inline constexpr std::size_t kTelegraphSteps = 9;
/// "fullAstern" ... "fullAhead": as in documents and command files.
const char* telegraphStepName(TelegraphStep step);

/// Shaft speed of every step, signed, ahead positive; strictly increasing, 0 at Stop.
using TelegraphTable = std::array<double, kTelegraphSteps>;

/// A fixed-pitch propeller on its shaft and the engine that turns it.
struct PropulsionUnit {
    std::string id;
    BodyPoint position;
    double diameter_m = 0.0;
    std::array<double, 3> thrustCoefficients{};  ///< KT = c0 + c1 J + c2 J^2, ahead
    double wakeFraction = 0.0;
    double thrustDeduction = 0.0;
    double asternThrustRatio = 0.0;  ///< bollard pull astern over ahead at the same shaft speed
    double shaftRate_rpsps = 0.0;    ///< fastest change of shaft speed
    double reversingTime_s = 0.0;    ///< shaft stands still that long between ahead and astern
};

struct Propulsion {
    std::vector<PropulsionUnit> units;  ///< port to starboard
    TelegraphTable telegraph_rps{};
    Provenance provenance;
};
Propulsion readPropulsion(config::Reader& in);

/// Rudders are moved together by one gear with two pumps.
struct Steering {
    std::vector<BodyPoint> rudders;
    double areaEach_m2 = 0.0;
    double liftSlope_perRad = 0.0;  ///< lift coefficient per angle in free flow
    double stallAngle_rad = 0.0;    ///< the lift grows no further
    double limit_rad = 0.0;
    double rate_radps = 0.0;  ///< with both pumps; half of it with one
    double lag_s = 0.0;       ///< 0: the gear runs at its rate until the order is reached
    double raceShare = 0.0;   ///< part of the added race velocity squared that acts on the rudder
    Provenance provenance;
};
Steering readSteering(config::Reader& in);

}  // namespace sagara::core
