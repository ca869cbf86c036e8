#pragma once

#include "core/vessel/Machinery.h"

namespace sagara::core {

/// Thrust of one propeller on the water (deduction not applied), ahead positive, for any shaft and ship
/// speed. Ahead: rho n^2 D^4 KT(J), J = (1 - w) u / (n D), KT held at its value for J = -0.6 and J = 1.4
/// beyond these. Astern: bollard thrust times the unit's astern ratio, falling off with sternway by the same
/// chord; headway leaves it as it is, because the engine's torque then holds it. Stopped: nothing. Trend only
/// outside J 0 to 1; four-quadrant data belong to the mmg model.
double openWaterThrust_N(const PropulsionUnit& unit, double shaft_rps, double surge_mps,
                         double density_kgpm3);

/// Square of the velocity a working propeller adds in its race, m^2/s^2: 2 T / (rho A), 0 unless it drives
/// ahead (actuator disc, Rankine-Froude).
double addedRaceSquared(const PropulsionUnit& unit, double thrust_N, double density_kgpm3);

}  // namespace sagara::core
