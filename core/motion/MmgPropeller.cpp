#include "core/motion/MmgPropeller.h"

#include <cmath>

namespace sagara::core {

MmgPropeller mmgPropeller(const MmgParameters& model, const Hull& hull, const Propeller& screw,
                          const ScrewOrder& order, const ShipMotion& m, const MmgFlow& flow) {
    const PropulsionUnit& unit = screw.unit();
    const BodyPoint local_mps = velocityAt(m, unit.position);
    const double along = std::cos(order.azimuth_rad), across = std::sin(order.azimuth_rad);
    MmgPropeller p;
    if (local_mps.x_m > 0.0) {
        const double drift_rad = flow.drift_rad - unit.position.x_m / hull.lengthBp_m * flow.r;
        const bool fromOutboard = unit.position.y_m > 0.0 ? drift_rad < 0.0 : drift_rad >= 0.0;
        const double C2 = fromOutboard ? model.wake.C2port : model.wake.C2starboard;
        p.wake = 1.0 - model.wake.inflow * (1.0 - unit.wakeFraction) *
                           (1.0 + (1.0 - std::exp(-model.wake.C1 * std::abs(drift_rad))) * (C2 - 1.0));
    }
    p.inflow_mps = along * (1.0 - p.wake) * local_mps.x_m + across * local_mps.y_m;
    p.thrust_N = screw.force(order.shaft_rps, order.pitch, p.inflow_mps, hull.waterDensity_kgpm3).thrust_N;
    const double push_N = model.wake.push * (1.0 - unit.thrustDeduction) * p.thrust_N;
    p.load = forceAt(unit.position, -0.5 * hull.draught_m, {along * push_N, across * push_N});
    return p;
}

}  // namespace sagara::core
