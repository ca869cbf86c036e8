#pragma once

#include "core/exercise/State.h"

namespace sagara::core {

/// What is the same for every ship in one tick, taken at its middle.
struct TickEnvironment {
    TickEnvironment(const World& world, const State& state);
    ActiveWaves waves;
    WindVelocity wind;
    double tide_m;
};

/// What pushes one own ship in one tick. Waves and wind act for the whole tick as they are in its middle;
/// what is stiff is worked out for every stage of it. The state outlives it and keeps its place; of the
/// ship's own state only the motion may change meanwhile.
class TickLoads {
public:
    TickLoads(const World& world, const State& state, std::size_t index, const TickEnvironment& environment);

    /// Rate of her motion: with these loads, and with what is held held.
    ShipMotion rate(const ShipMotion& m, const Actuators& actuators) const;
    const Obstacles& obstacles() const { return m_obstacles; }

    Load wind() const { return m_wind; }
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
    Load m_slow;  ///< wind and anchors
    Obstacles m_obstacles;
    bool m_nearGround;
};

}  // namespace sagara::core
