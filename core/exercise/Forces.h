#pragma once

#include <array>

#include "core/exercise/ForceCause.h"
#include "core/exercise/State.h"

namespace sagara::core {

/// Forces on an own ship at this moment by cause, frame B about Bo; only surge, sway and yaw are set. Made
/// for people to look at: it costs about what a tick of the ship costs, so ask a few times a second.
using ShipForces = std::array<Load, kForceCauses>;
ShipForces forcesOn(const World& world, const State& state, std::size_t ship);

inline const Load& of(const ShipForces& forces, ForceCause cause) {
    return forces[static_cast<std::size_t>(cause)];
}
Load sumOf(const ShipForces& forces);

}  // namespace sagara::core
