#pragma once

#include "core/exercise/LocalWater.h"

namespace sagara::core {

/// All traffic for one tick: each follows her own wants.
void moveTargets(const World& world, State& state, const WaterNow& water, double dt_s);

}  // namespace sagara::core
