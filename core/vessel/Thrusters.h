#pragma once

#include <string>
#include <vector>

#include "core/base/Planar.h"
#include "core/vessel/Provenance.h"

namespace sagara::core {

/// A propeller in a tunnel across the ship, at bow or stern.
struct Thruster {
    std::string id;
    BodyPoint position;
    double height_m = 0.0;    ///< of its axis above the waterline: negative
    double diameter_m = 0.0;  ///< of the tunnel
    double thrust_N = 0.0;    ///< at full power, the ship at rest
    double rampTime_s = 0.0;  ///< from stop to full
};

/// Group "thrusters" of a vessel document, if she has any.
struct Thrusters {
    std::vector<Thruster> units;
    Provenance provenance;
};
Thrusters readThrusters(config::Reader& in);

/// Thrust at rest of a tunnel thruster by its power: C (rho A P^2)^(1/3) with the static merit coefficient
/// C = 0.95 usual of tunnels (1.26 is an ideal open disc): Beveridge (1972), Marine Technology 8(4), 439-453.
double tunnelThrust_N(double power_W, double diameter_m, double density_kgpm3);

}  // namespace sagara::core
