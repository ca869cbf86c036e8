#include "core/exercise/Forces.h"

#include "core/exercise/TickLoads.h"

namespace sagara::core {

ShipForces forcesOn(const World& world, const State& state, std::size_t index) {
    const OwnShip& ship = *world.ships[index];
    const OwnShipState& s = state.ships[index];
    const TickEnvironment environment(world, state);
    const Actuators actuators = actuatorsOf(ship, s);
    const TickLoads loads(world, state, index, environment, actuators);
    const ShipMotion throughWater = ship.dynamics.throughWater(s.motion, loads.waves().forces);
    const HullForces own = ship.dynamics.hullForces(throughWater, actuators, loads.depth_m());

    ShipForces forces;
    const auto set = [&](ForceCause cause, const Load& l) {
        forces[static_cast<std::size_t>(cause)] = {
            .surge_N = l.surge_N, .sway_N = l.sway_N, .yaw_Nm = l.yaw_Nm};
    };
    set(ForceCause::Hull, own.hull + loads.confined());
    set(ForceCause::Rudder, own.rudder);
    set(ForceCause::Propeller, own.propeller);
    set(ForceCause::Wind, loads.wind());
    set(ForceCause::Waves, waveLoad(loads.waves()));
    set(ForceCause::Lines, loads.lines(s.motion));
    set(ForceCause::Anchors, loads.anchors(s.motion));
    set(ForceCause::Contact, loads.contact(s.motion));
    return forces;
}

Load sumOf(const ShipForces& forces) {
    Load sum;
    for (const Load& force : forces) sum = sum + force;
    return sum;
}

}  // namespace sagara::core
