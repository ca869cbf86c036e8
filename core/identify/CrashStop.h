#pragma once

#include "core/identify/Trial.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

class TrialShip;

/// Telegraph from ahead to astern, rudder amidships, until she is stopped in the water. Measures:
/// track_reach_over_L, head_reach_over_L, side_reach_over_L (to starboard positive), stopping_time_s and
/// stopping_heading_deg (to starboard positive).
struct CrashStop {
    TelegraphStep order = TelegraphStep::FullAstern;
    double rudder_rad = 0.0;
};
Trial runCrashStop(TrialShip& ship, const CrashStop& stop, const TrialOptions& options = {});
Trial runCrashStop(const Vessel& vessel, const CrashStop& stop = {}, const TrialOptions& options = {});

}  // namespace sagara::core
