#pragma once

#include "core/base/Units.h"
#include "core/identify/Trial.h"

namespace sagara::core {

class TrialShip;

/// Direct (Dieudonne) spiral: the rudder goes by steps from one side to the other and back, each angle held
/// until the yaw rate is steady. A ship that is not stable on her course has two yaw rates in a range of
/// rudder about amidships. Measures: r_dps_at_5_deg_to_port (steady, with the rudder moving to port) and so
/// on, and where the loop begins and ends: loop_from_deg (rudder at which she leaves the turn to starboard),
/// loop_to_deg, spiral_width_deg (0 for a stable ship), loop_height_dps (difference of the yaw rates
/// amidships).
struct Spiral {
    double rudder_rad = 25.0 * kDegree_rad;  ///< the first angle; positive to starboard
};
Trial runSpiral(TrialShip& ship, const Spiral& spiral, const TrialOptions& options = {});

}  // namespace sagara::core
