#include "core/exercise/TickLoads.h"

#include "core/exercise/Observe.h"
#include "core/motion/WindLoad.h"

namespace sagara::core {
namespace {

constexpr double kGroundNear_m = 1.5;  // with less water the ground is felt for in every stage

}  // namespace

TickEnvironment::TickEnvironment(const World& world, const State& state)
    : water(world, state, {state.time().us + kTick_us / 2}) {
    const SimTime middle{state.time().us + kTick_us / 2};
    activeWaves(world.waves, state.weather.sea, middle, waves);
    wind = world.gusts.at(state.weather.now.wind, middle);
}

TickLoads::TickLoads(const World& world, const State& state, std::size_t index,
                     const TickEnvironment& environment, const Actuators& actuators)
    : m_world(world),
      m_state(state),
      m_index(index),
      m_ship(*world.ships[index]),
      m_tide_m(environment.water.tide_m),
      m_depth_m(world.area.depth_m(state.ships[index].motion.position()) + m_tide_m),
      m_current(currentAt(world, environment.water, state.ships[index].motion.position())),
      m_nearGround(state.ships[index].underKeel_m < kGroundNear_m) {
    const OwnShipState& s = state.ships[index];
    const NorthEast ground = overGround_mps(s, m_current);
    const HeadingFrame frame({}, s.motion.heading_rad);
    ShipMotion middle = s.motion;  // of the tick
    const NorthEast place = s.motion.position() + 0.5 * kTick_s * ground;
    middle.north_m = place.north_m;
    middle.east_m = place.east_m;
    middle.heading_rad += 0.5 * kTick_s * s.motion.yawRate_radps;
    middle.down_m += 0.5 * kTick_s * s.motion.heaveRate_mps;
    middle.roll_rad += 0.5 * kTick_s * s.motion.rollRate_radps;
    middle.pitch_rad += 0.5 * kTick_s * s.motion.pitchRate_radps;
    m_waves = m_ship.dynamics.wavesAt(environment.waves, middle, environment.water.waves.factorAt(place));
    WindVelocity wind = environment.wind;
    wind.speed_mps *= windFactorAt(m_ship.vessel.windage.centroidHeight_m, world.windProfile, wind.speed_mps);
    m_wind = windLoad(m_ship.vessel.windage, m_ship.vessel.hull.lengthOverall_m, wind, s.motion.heading_rad,
                      frame.vectorInBody(ground));
    m_confined = confinedLoad(world, state, index, environment.water, actuators, m_depth_m);
    if (!world.streams.empty())
        m_confined = m_confined + streamLoad(world, environment.water, m_ship, s.motion, m_depth_m);
    m_slow = m_wind + m_confined;
    for (std::size_t k = 0; k < m_ship.anchorCount(); ++k) {
        m_slow = m_slow + anchorLoad(m_ship.vessel.groundTackle.anchors[k], s.anchors[k], s.motion);
    }
    findObstacles(world.area, m_ship.hull, s.motion, m_obstacles);
    addShips();
}

/// The ships that can be touched, as they are at the begin of the tick.
void TickLoads::addShips() {
    const OwnShip& own = m_ship;
    const NorthEast here = m_state.ships[m_index].motion.position();
    for (std::size_t i = 0; i < m_state.targets.size(); ++i) {
        const TargetState& t = m_state.targets[i];
        const TargetLayout& layout = targetLayout(m_world, m_state, i);
        if (!t.present || distance(t.position, here) > own.hull.radius_m + layout.length_m) continue;
        m_obstacles.ships.add({layout.outline,
                               {0.5 * layout.length_m, 0.5 * layout.beam_m},
                               t.position,
                               t.heading_rad,
                               t.velocity(),
                               layout.mass_kg(),
                               static_cast<std::int32_t>(i)});
    }
    for (std::size_t i = 0; i < m_state.ships.size(); ++i) {
        if (i == m_index) continue;
        const OwnShip& other = *m_world.ships[i];
        const OwnShipState& s = m_state.ships[i];
        if (distance(s.motion.position(), here) > own.hull.radius_m + other.hull.radius_m) continue;
        m_obstacles.ships.add({other.hull.outline, other.hull.halfSize, s.motion.position(),
                               s.motion.heading_rad,
                               overGround_mps(s, currentAt(m_world, m_state, s.motion.position())),
                               other.hull.lateralMass_kg, -1 - static_cast<std::int32_t>(i)});
    }
}

MovingShip TickLoads::rate(const MovingShip& ship, const Actuators& actuators) const {
    const ShipMotion& m = ship.motion;
    const OwnShipState& s = m_state.ships[m_index];
    Load load = m_slow;
    for (std::size_t k = 0; k < m_ship.lines.size(); ++k) {
        load = load + lineLoad(m_ship.vessel.mooring, m_ship.lines[k], s.lines[k], m, m_current);
    }
    if (!m_obstacles.empty()) load = load + contactLoad(m_obstacles, m_ship.hull, m, m_current);
    if (m_nearGround) load = load + groundLoad(m_world.area, m_ship.keel, m, m_tide_m, m_current);
    MovingShip rate = m_ship.dynamics.derivative(ship, actuators, load, m_waves, m_current, m_depth_m);
    if (s.freeMotions != kAllMotions) holdMotions(s.freeMotions, rate.motion);
    return rate;
}

Load TickLoads::anchors(const ShipMotion& m) const {
    Load sum;
    for (std::size_t k = 0; k < m_ship.anchorCount(); ++k) {
        sum = sum + anchorLoad(m_ship.vessel.groundTackle.anchors[k], m_state.ships[m_index].anchors[k], m);
    }
    return sum;
}

Load TickLoads::lines(const ShipMotion& m) const {
    Load sum;
    for (std::size_t k = 0; k < m_ship.lines.size(); ++k) {
        sum = sum +
              lineLoad(m_ship.vessel.mooring, m_ship.lines[k], m_state.ships[m_index].lines[k], m, m_current);
    }
    return sum;
}

Load TickLoads::contact(const ShipMotion& m) const {
    Load sum;
    if (!m_obstacles.empty()) sum = sum + contactLoad(m_obstacles, m_ship.hull, m, m_current);
    if (m_nearGround) sum = sum + groundLoad(m_world.area, m_ship.keel, m, m_tide_m, m_current);
    return sum;
}

}  // namespace sagara::core
