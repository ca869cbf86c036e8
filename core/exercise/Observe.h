#pragma once

#include "core/assess/Observation.h"
#include "core/exercise/Event.h"
#include "core/exercise/State.h"

namespace sagara::core {

/// What an assessor sees of one own ship now.
Observation observe(const World& world, const State& state, std::size_t ship);

/// Velocity over the ground, frame N.
NorthEast overGround_mps(const OwnShipState& ship, NorthEast current);

/// Hull to the nearest quay or shore, at most kShoreLimit_m.
double clearOfShore_m(const Area& area, const OwnShip& ship, const ShipMotion& m);

/// An event as the assessment takes it; nothing for kinds that are not graded at once.
std::optional<Happening> happeningOf(const Event& event);

}  // namespace sagara::core
