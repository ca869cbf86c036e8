#pragma once

#include <vector>

#include "core/exercise/State.h"

namespace sagara::core {

struct PredictedPose {
    SimTime time;
    NorthEast position;
    double heading_rad = 0.0;
};

/// Where one own ship will be if nobody touches anything: a copy of the State, advanced and dropped. The copy
/// has no traffic, no waves and no gusts, which would only blur the line, and is not graded. Poses every
/// `every_s` seconds, the first is now. Stops early when the ship does (aground, not finite).
std::vector<PredictedPose> predict(const World& world, const State& now, std::size_t ship, double seconds,
                                   double every_s);

}  // namespace sagara::core
