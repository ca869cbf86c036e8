#pragma once

#include "core/motion/MmgPropeller.h"

namespace sagara::core {

/// One rudder: what it meets and what it does.
struct MmgRudderForce {
    double u_mps = 0.0;  ///< inflow along the ship, from ahead positive
    double v_mps = 0.0;  ///< and across, flow towards starboard positive
    double normal_N = 0.0;
    Load load;
};

/// Inflow and force by Yasukawa and Yoshimura (2015), eq 18 to 27, exact for flow from ahead. Beyond: with
/// the screw pulling astern the race reaches the rudder as a suction of half its strength and the inflow may
/// reverse; flow from aft meets a rudder without hull before it, with 0.6 of the lift; past the stall angle
/// of the steering group the normal force goes over to that of a flat plate (trend only).
/// `screw`: the propeller before this rudder; `inRace` whether its race reaches it.
MmgRudderForce mmgRudderForce(const MmgParameters& model, const Hull& hull, const Steering& steering,
                              BodyPoint position, double angle_rad, const PropulsionUnit& unit,
                              const MmgPropeller& screw, bool inRace, const ShipMotion& m,
                              const MmgFlow& flow);

}  // namespace sagara::core
