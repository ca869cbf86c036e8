#pragma once

#include "core/motion/MmgHullForce.h"
#include "core/vessel/Machinery.h"

namespace sagara::core {

/// One propeller behind the hull.
struct MmgPropeller {
    double wake = 0.0;        ///< effective wake fraction in the turn
    double inflow_mps = 0.0;  ///< u_A, ahead positive
    double thrust_N = 0.0;    ///< on the water, before deduction
    Load load;
};

/// Wake by Yasukawa and Yoshimura (2015), eq 16; with sternway there is none. A screw off the centreline
/// meets the ship's speed there, u - r y. Thrust in four quadrants: openWaterThrust_N.
MmgPropeller mmgPropeller(const MmgModel& model, const Hull& hull, const PropulsionUnit& unit,
                          double shaft_rps, const ShipMotion& m, const MmgFlow& flow);

}  // namespace sagara::core
