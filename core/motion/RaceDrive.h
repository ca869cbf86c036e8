#pragma once

#include "core/motion/Actuators.h"
#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/PolynomialModel.h"

namespace sagara::core {

/// Propeller and rudder as published with a set by Son and Nomoto (J. Soc. Naval Arch. Japan 150, 1981): the
/// wake grows with drift and yaw at the propeller, the race behind it feeds the rudder, the rudder works on
/// the hull as well. For shafts that go ahead.
HullForces raceDriveForces(const RaceDrive& drive, double length_m, double density_kgpm3, const ShipMotion& m,
                           const Actuators& actuators);

}  // namespace sagara::core
