#include "core/motion/MmgPropeller.h"

#include <cmath>

#include "core/motion/Propeller.h"

namespace sagara::core {

MmgPropeller mmgPropeller(const MmgModel& model, const Hull& hull, const PropulsionUnit& unit,
                          double shaft_rps, const ShipMotion& m, const MmgFlow& flow) {
    const double surge_mps = m.surge_mps - m.yawRate_radps * unit.position.y_m;
    MmgPropeller p;
    if (surge_mps > 0.0) {
        const double drift_rad = flow.drift_rad - unit.position.x_m / hull.lengthBp_m * flow.r;
        const bool fromPort = unit.position.y_m < 0.0 ? drift_rad < 0.0 : drift_rad >= 0.0;
        const double C2 = fromPort ? model.wake.C2port : model.wake.C2starboard;
        p.wake = 1.0 - (1.0 - unit.wakeFraction) *
                           (1.0 + (1.0 - std::exp(-model.wake.C1 * std::abs(drift_rad))) * (C2 - 1.0));
    }
    p.inflow_mps = (1.0 - p.wake) * surge_mps;
    p.thrust_N =
        openWaterThrust_N(unit, shaft_rps, p.inflow_mps / (1.0 - unit.wakeFraction), hull.waterDensity_kgpm3);
    p.load.surge_N = (1.0 - unit.thrustDeduction) * p.thrust_N;
    p.load.yaw_Nm = -unit.position.y_m * p.load.surge_N;
    return p;
}

}  // namespace sagara::core
