#pragma once

#include <vector>

#include "core/exercise/Event.h"
#include "core/exercise/TickLoads.h"

namespace sagara::core {

/// Ten times a second: whether the sea comes over the bow of an own ship (EventKind::GreenWater) or her
/// forefoot comes out of it and slams (EventKind::Slam). Each is told once until it has been over for some
/// seconds.
void watchBow(const World& world, State& state, std::size_t index, const TickEnvironment& environment,
              std::vector<Event>& events);

}  // namespace sagara::core
