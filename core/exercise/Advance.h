#pragma once

#include <span>
#include <vector>

#include "core/exercise/Event.h"
#include "core/exercise/State.h"

namespace sagara::core {

/// One tick of 20 ms. Pure and deterministic: same world, state and commands give the same state and events.
/// `commands` are those of this tick, in the order they were given. No clock, no I/O; no allocation unless
/// something happens. When a value is not finite the state is marked stopped, an event names ship and
/// component, and further calls do nothing.
std::vector<Event> advance(const World& world, State& state, std::span<const Command> commands = {});

}  // namespace sagara::core
