#pragma once

#include <vector>

#include "core/exercise/Event.h"
#include "core/exercise/State.h"

namespace sagara::core {

/// Carries out one order in this tick. An order for a ship, line or target that does not exist does nothing.
void applyOrder(const World& world, State& state, std::uint8_t ship, const Order& order,
                std::vector<Event>& events);

/// Fires an event of the scenario once.
void fireEvent(const World& world, State& state, std::uint32_t index, std::vector<Event>& events);

/// Targets that the level asks for come, those above it go.
void bringTargets(const World& world, State& state, std::vector<Event>& events);

}  // namespace sagara::core
