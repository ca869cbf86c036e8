#pragma once

#include "core/exercise/State.h"

namespace sagara::core {

/// All traffic for one tick: each follows her own wants.
void moveTargets(const World& world, State& state, double dt_s);

}  // namespace sagara::core
