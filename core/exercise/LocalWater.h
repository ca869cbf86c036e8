#pragma once

#include "core/exercise/State.h"
#include "core/motion/ShipInteraction.h"
#include "core/world/LocalWaves.h"

/// The water where a ship is: what is not the same over the whole area.
namespace sagara::core {

/// What of it is the same for all places in one tick.
struct WaterNow {
    WaterNow(const World& world, const State& state, SimTime time);
    NorthEast uniform;  ///< current of the weather
    TidalClock clock;
    double tide_m = 0.0;  ///< above chart datum
    LocalWaves waves;
};

/// Current at a place: that of the weather and the area's streams together.
NorthEast currentAt(const World& world, const WaterNow& now, NorthEast p);
NorthEast currentAt(const World& world, const State& state, NorthEast p);

/// What a current that changes along her way and her length adds to a ship: she keeps her own momentum while
/// the water about her changes, -m (v . grad) current, v through the water; and her hull turns against the
/// turning of the water.
Load streamLoad(const World& world, const WaterNow& now, const OwnShip& ship, const ShipMotion& m,
                double depth_m);

/// What the ground, the banks and passing ships add, as her document asks.
Load confinedLoad(const World& world, const State& state, std::size_t ship, const WaterNow& now,
                  const Actuators& actuators, double depth_m);

/// What passing own ships do to a target that keeps her course and speed: changes of her speed and turn.
void pushTarget(const World& world, const State& state, const TargetLayout& layout, TargetState& target,
                const WaterNow& now, double dt_s);

}  // namespace sagara::core
