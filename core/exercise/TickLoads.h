#pragma once

#include "core/exercise/LocalWater.h"

namespace sagara::core {

/// What is the same for every ship in one tick, taken at its middle.
struct TickEnvironment {
    TickEnvironment(const World& world, const State& state);
    ActiveWaves waves;
    WindVelocity wind;
    WaterNow water;
};

/// What pushes one own ship in one tick. Waves and wind act for the whole tick as they are in its middle;
/// what is stiff is worked out for every stage of it. The state outlives it and keeps its place; of the
/// ship's own state only the motion may change meanwhile.
class TickLoads {
public:
    /// `actuators`: as they stand in this tick.
    TickLoads(const World& world, const State& state, std::size_t index, const TickEnvironment& environment,
              const Actuators& actuators);

    /// Rate of her motion: with these loads, and with what is held held.
    MovingShip rate(const MovingShip& ship, const Actuators& actuators) const;
    const Obstacles& obstacles() const { return m_obstacles; }

    Load wind() const { return m_wind; }
    /// What ground, banks, passing ships and the change of the current from place to place do to the hull.
    Load confined() const { return m_confined; }
    NorthEast current() const { return m_current; }
    Load anchors(const ShipMotion& m) const;
    Load lines(const ShipMotion& m) const;
    Load contact(const ShipMotion& m) const;  ///< with quays, ships and the ground
    const WaveEffect& waves() const { return m_waves; }
    double depth_m() const { return m_depth_m; }  ///< of the water at midship

private:
    void addShips();

    const World& m_world;
    const State& m_state;
    std::size_t m_index;
    const OwnShip& m_ship;
    double m_tide_m;
    double m_depth_m;
    NorthEast m_current;
    WaveEffect m_waves;
    Load m_wind;
    Load m_confined;
    Load m_slow;  ///< wind, anchors and what the place does
    Obstacles m_obstacles;
    bool m_nearGround;
};

}  // namespace sagara::core
