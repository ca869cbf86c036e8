#pragma once

#include "core/base/Units.h"
#include "core/identify/Trial.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

class TrialShip;

/// Rudder to one side until the heading has changed by the switching angle, then to the other, and so on.
/// Measures: initial_turning_time_s, initial_turning_over_L (track to the first switch: the initial turning
/// ability when rudder and switch are 10 deg), execute_2_time_s ..., overshoot_1_deg ... (the first belongs
/// to the second execute), max_abs_roll_deg.
struct Zigzag {
    double rudder_rad = 10.0 * kDegree_rad;
    double switch_rad = 10.0 * kDegree_rad;
    bool starboardFirst = true;
    /// The run ends when the overshoot of the last is over; a run of a given duration goes on reversing.
    int executes = 5;
    /// Time between looks at the heading, as in published runs of fixed step; 0: the order is given right at
    /// it.
    double look_s = 0.0;
};
Trial runZigzag(TrialShip& ship, const Zigzag& zigzag, const TrialOptions& options = {});
Trial runZigzag(const Vessel& vessel, const Zigzag& zigzag, const TrialOptions& options = {});

}  // namespace sagara::core
