#pragma once

#include "core/motion/Actuators.h"
#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Hull.h"
#include "core/vessel/Thrusters.h"

namespace sagara::core {

/// What is left of a bow thruster's force and of its turning moment about midship when the ship moves ahead.
struct ThrusterFade {
    double force = 1.0;
    double moment = 1.0;
};
/// `speedRatio`: ship's speed over that of the jet. The jet is bent along the hull and draws water off the
/// side it came from, so that the force falls to about 0.43 and the moment to about 0.67 at ratios of 0.3 to
/// 0.6 and both recover beyond: Chislett and Bjoerheden (1966), HyA report Hy-8; Beveridge (1972), Marine
/// Technology 8(4), 439-453, fig. 2; Brix (1993), Manoeuvring Technical Manual. Recalled from these curves,
/// which differ among ships by some 0.1, not read off them; held beyond 1.
ThrusterFade thrusterFade(double speedRatio);

/// Velocity of the jet of a tunnel thruster at this thrust: sqrt(T / (rho A)).
double jetSpeed_mps(const Thruster& thruster, double thrust_N, double density_kgpm3);

/// Load of one thruster at a share of its thrust at rest, -1 to 1, starboard positive. The loss is in
/// proportion to the hull downstream of the tunnel: whole at the bow going ahead, none at the stern; the
/// other way round astern.
Load thrusterLoad(const Thruster& thruster, double share, double surge_mps, const Hull& hull);
/// Of all thrusters.
Load thrusterLoad(const Thrusters& thrusters, const ShipMotion& m, const Actuators& actuators,
                  const Hull& hull);

}  // namespace sagara::core
