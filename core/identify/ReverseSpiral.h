#pragma once

#include "core/base/Units.h"
#include "core/identify/Trial.h"

namespace sagara::core {

class TrialShip;

/// Reverse spiral (Bech 1968, "The reverse spiral test as applied to large ships", Shipping World and
/// Shipbuilder): she is steered to one steady yaw rate after the other, and the rudder that it takes is
/// noted. Unlike the direct spiral it tells the unstable branch too. From the steady turn of the first rudder
/// angle to its mirror and through the rates between, evenly. Measures: rudder_deg_at_0.2_dps (mean of the
/// last length run; rates to four decimals) and so on; loop_from_deg, loop_to_deg, spiral_width_deg as of the
/// direct spiral.
struct ReverseSpiral {
    double rudder_rad = 25.0 * kDegree_rad;  ///< of the first turn; positive to starboard
    int steps = 16;                          ///< of the yaw rate, from one side to the other
};
Trial runReverseSpiral(TrialShip& ship, const ReverseSpiral& spiral, const TrialOptions& options = {});

}  // namespace sagara::core
