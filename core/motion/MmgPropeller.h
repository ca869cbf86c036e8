#pragma once

#include "core/motion/MmgHullForce.h"
#include "core/motion/Propeller.h"

namespace sagara::core {

/// One propeller behind the hull.
struct MmgPropeller {
    double wake = 0.0;        ///< effective wake fraction in the turn
    double inflow_mps = 0.0;  ///< into the disc along the shaft, from ahead positive
    double thrust_N = 0.0;    ///< on the water, before deduction
    Load load;
};

/// What its machinery does.
struct ScrewOrder {
    double shaft_rps = 0.0;
    double pitch = 1.0;
    double azimuth_rad = 0.0;
};

/// Wake by Yasukawa and Yoshimura (2015), eq 16; with sternway there is none. A screw off the centreline
/// meets the ship's speed there, u - r y; an azimuth drive the flow along its own axis. Thrust in four
/// quadrants: Propeller.
MmgPropeller mmgPropeller(const MmgParameters& model, const Hull& hull, const Propeller& screw,
                          const ScrewOrder& order, const ShipMotion& m, const MmgFlow& flow);

}  // namespace sagara::core
