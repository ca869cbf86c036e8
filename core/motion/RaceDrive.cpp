#include "core/motion/RaceDrive.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {

HullForces raceDriveForces(const RaceDrive& k, double length_m, double density_kgpm3, const ShipMotion& m,
                           const Actuators& actuators) {
    const double L = length_m, D = k.diameter_m;
    const double U = std::max(1e-3, std::hypot(m.surge_mps, m.sway_mps));
    const double u = m.surge_mps / U, v = m.sway_mps / U, r = m.yawRate_radps * L / U;  // as published
    const double n_rps = std::max(0.0, actuators.shaft_rps[0]);

    const double drift = v + k.xp * r;
    const double inflow = u * ((1.0 - k.wp) + k.tau * (drift * drift + k.cpv * v + k.cpr * r));
    const double inflow_mps = inflow * U, tip_mps = n_rps * D;
    const double J = tip_mps > 0.0 ? inflow_mps / tip_mps : 0.0;
    const double KT = k.thrustCoefficients[0] + J * (k.thrustCoefficients[1] + J * k.thrustCoefficients[2]);
    HullForces f;
    f.propeller.surge_N = (1.0 - k.t) * density_kgpm3 * tip_mps * tip_mps * D * D * KT;

    const double across = k.ga * v + k.cRr * r + k.cRrrr * r * r * r + k.cRrrv * r * r * v;
    // uR = uP eps sqrt(1 + 8 kk KT / (pi J^2)), free of division by J
    const double along2 =
        k.eps * k.eps * std::max(0.0, inflow_mps * inflow_mps + 8.0 * k.kk * KT * tip_mps * tip_mps / kPi);
    const double along_mps = std::copysign(std::sqrt(along2), inflow_mps), across_mps = across * U;
    const double angle_rad = actuators.rudder_rad + std::atan2(across_mps, along_mps);
    const double slope = 6.13 * k.aspect / (k.aspect + 2.25);  // Fujii
    const double normal_N =
        -0.5 * density_kgpm3 * slope * k.area_m2 * (along2 + across_mps * across_mps) * std::sin(angle_rad);
    const double side_N = normal_N * std::cos(actuators.rudder_rad);
    f.rudder.surge_N = k.cRX * normal_N * std::sin(actuators.rudder_rad);
    f.rudder.sway_N = (1.0 + k.aH) * side_N;
    f.rudder.roll_Nm = -(1.0 + k.aH) * k.zR * L * side_N;
    f.rudder.yaw_Nm = (k.xR + k.aH * k.xH) * L * side_N;
    return f;
}

}  // namespace sagara::core
