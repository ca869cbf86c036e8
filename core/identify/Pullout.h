#pragma once

#include "core/base/Units.h"
#include "core/identify/Trial.h"

namespace sagara::core {

class TrialShip;

/// Rudder over until the turn is steady, then amidships until the yaw rate is steady again. A ship that is
/// stable on her course comes to rest (or to the small yaw rate that a single screw gives); one that is not
/// keeps turning. Measures: steady_r_dps in the turn, release_time_s, residual_yaw_rate_dps at the end (mean
/// over the last length run), and residual_ratio of the two.
struct Pullout {
    double rudder_rad = 20.0 * kDegree_rad;  ///< positive to starboard
};
Trial runPullout(TrialShip& ship, const Pullout& pullout, const TrialOptions& options = {});

}  // namespace sagara::core
