#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Planar.h"
#include "core/vessel/OpenWater.h"
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

/// Blades that turn in their hub. Pitch is over the design pitch: 1 there, below 0 it drives astern. The
/// shaft turns one way; the lever (an order of shaft speed, astern negative) sets pitch first, then
/// revolutions.
struct PitchControl {
    double least = -0.7;
    double most = 1.0;
    double rate_perS = 0.05;
    double slowest_rps = 0.0;  ///< of the shaft
};

/// A drive that turns about a vertical axis. The wheel turns it too.
struct AzimuthDrive {
    double rate_radps = 0.2;
};

/// Compressed air that starts a direct-drive engine, ahead or astern.
struct StartAir {
    double starts = 12.0;     ///< in full bottles
    double refill_s = 150.0;  ///< of the compressors, for one start
};

/// What turns a shaft, where the document says so: torque, inertia, starting.
struct Engine {
    double torque_Nm = 0.0;            ///< at the shaft, at full speed
    double full_rps = 0.0;             ///< of the shaft
    double idle_rps = 0.0;             ///< slowest it runs
    double inertia_kgm2 = 0.0;         ///< of engine, shaft, propeller and its water, at the shaft
    std::optional<StartAir> startAir;  ///< none: a clutch, or electric
};

/// A propeller on its shaft and what turns it.
struct PropulsionUnit {
    std::string id;
    BodyPoint position;
    double diameter_m = 0.0;
    std::array<double, 3> thrustCoefficients{};  ///< KT = c0 + c1 J + c2 J^2, ahead
    double wakeFraction = 0.0;
    double thrustDeduction = 0.0;
    double asternThrustRatio = 0.0;       ///< bollard pull astern over ahead; with openWater: unused
    double shaftRate_rpsps = 0.0;         ///< fastest change of shaft speed
    double reversingTime_s = 0.0;         ///< shaft stands still that long between ahead and astern
    std::optional<OpenWater> openWater;   ///< all four quadrants, with torque; none: see Propeller
    std::optional<PitchControl> pitch;    ///< none: fixed blades
    std::optional<AzimuthDrive> azimuth;  ///< none: a shaft
    std::optional<Engine> engine;         ///< none: the shaft follows its order at its rate
};

struct Propulsion {
    std::vector<PropulsionUnit> units;  ///< port to starboard
    TelegraphTable telegraph_rps{};
    Provenance provenance;
};
Propulsion readPropulsion(config::Reader& in);

/// Rudders are moved together by one gear with two pumps. None where azimuth drives steer.
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
