#include "core/exercise/MoveShip.h"

#include <algorithm>
#include <cmath>

#include "core/bridge/Pilot.h"
#include "core/exercise/Observe.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/WindLoad.h"

namespace sagara::core {
namespace {

constexpr double kGroundNear_m = 1.5;       // with less water the ground is felt for in every stage
constexpr double kContactNoise_mps = 0.03;  // softer touches are not reported
constexpr std::int64_t kNewContact_ticks = kTicksPerSecond;  // apart this long, a touch is a new one

/// The ships that can be touched, as they are at the begin of the tick.
void addShips(const World& world, const State& state, std::size_t index, Obstacles& obstacles) {
    const OwnShip& own = *world.ships[index];
    const NorthEast here = state.ships[index].motion.position();
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetState& t = state.targets[i];
        const TargetLayout& layout = world.targets[i];
        if (!t.present || distance(t.position, here) > own.hull.radius_m + layout.length_m) continue;
        obstacles.ships.add({layout.outline,
                             {0.5 * layout.length_m, 0.5 * layout.beam_m},
                             t.position,
                             t.heading_rad,
                             t.velocity(),
                             layout.mass_kg(),
                             static_cast<std::int32_t>(i)});
    }
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        if (i == index) continue;
        const OwnShip& other = *world.ships[i];
        const OwnShipState& s = state.ships[i];
        if (distance(s.motion.position(), here) > own.hull.radius_m + other.hull.radius_m) continue;
        obstacles.ships.add({other.hull.outline, other.hull.halfSize, s.motion.position(),
                             s.motion.heading_rad, overGround_mps(s, state.weather.now.current),
                             other.hull.lateralMass_kg, -1 - static_cast<std::int32_t>(i)});
    }
}

Actuators runMachinery(const World& world, const OwnShip& ship, OwnShipState& s) {
    runPilot(world.pilot, world.path, ship, s, kTick_s);
    s.steering.order_rad =
        steerAutopilot_rad(ship, world.path, s.motion, s.autopilot, s.steering.order_rad, kTick_s);
    Actuators actuators;
    actuators.rudder_rad = runSteeringGear(ship.vessel.steering, s.steering, kTick_s);
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) {
        runShaft(ship.vessel.propulsion.units[i], s.shafts[i], kTick_s);
        actuators.shaft_rps[i] = s.shafts[i].speed_rps;
    }
    return actuators;
}

/// New blows become events; a ship that is hit loses her way.
void reportContacts(const Touches& touches, State& state, std::size_t index, std::vector<Event>& events) {
    for (std::size_t kind = 0; kind < kContactKinds; ++kind) {
        ContactMemory& memory = state.ships[index].contacts[kind];
        const Touch& touch = touches[kind];
        const bool isNew = touch.touching && state.tick - memory.lastTick > kNewContact_ticks;
        memory.touching = touch.touching;
        if (touch.touching) memory.lastTick = state.tick;
        const bool ship = static_cast<ContactKind>(kind) == ContactKind::Ship;
        if (!isNew || (!ship && touch.approach_mps < kContactNoise_mps)) continue;
        Event e;
        e.tick = state.tick;
        e.kind = EventKind::Contact;
        e.ship = static_cast<std::uint8_t>(index);
        e.contact = static_cast<ContactKind>(kind);
        e.index = touch.other;
        e.place = touch.place;
        e.value = touch.approach_mps;
        e.energy_J = touch.energy_J;
        events.push_back(e);
        if (ship && touch.other >= 0) state.targets[static_cast<std::size_t>(touch.other)].stopped = true;
    }
}

void reportGround(State& state, std::size_t index, double clearance_m, std::vector<Event>& events) {
    OwnShipState& s = state.ships[index];
    s.underKeel_m = clearance_m;
    constexpr double kAfloat_m = 0.1;
    const bool aground = clearance_m < (s.aground ? kAfloat_m : 0.0);
    if (aground == s.aground) return;
    s.aground = aground;
    Event e;
    e.tick = state.tick;
    e.kind = aground ? EventKind::Grounding : EventKind::Afloat;
    e.ship = static_cast<std::uint8_t>(index);
    e.place = s.motion.position();
    e.value = std::hypot(s.motion.surge_mps, s.motion.sway_mps);
    events.push_back(e);
}

/// Index for componentName of the first value that is not finite, or -1.
std::int32_t notFinite(const ShipMotion& m) {
    const double values[] = {
        m.north_m + m.east_m, m.down_m,
        m.roll_rad,           m.pitch_rad,
        m.heading_rad,        m.surge_mps,
        m.sway_mps,           m.heaveRate_mps + m.rollRate_radps + m.pitchRate_radps + m.yawRate_radps};
    for (std::size_t i = 0; i < std::size(values); ++i) {
        if (!std::isfinite(values[i])) return static_cast<std::int32_t>(i);
    }
    return -1;
}

}  // namespace

TickEnvironment::TickEnvironment(const World& world, const State& state) {
    const SimTime middle{state.time().us + kTick_us / 2};
    activeWaves(world.waves, state.weather.sea, middle, waves);
    wind = world.gusts.at(state.weather.now.wind, middle);
    tide_m = world.tide.height_m(middle);
}

void moveShip(const World& world, State& state, std::size_t index, const TickEnvironment& environment,
              std::vector<Event>& events) {
    const OwnShip& ship = *world.ships[index];
    OwnShipState& s = state.ships[index];
    const NorthEast current = state.weather.now.current, ground = overGround_mps(s, current);
    const Actuators actuators = runMachinery(world, ship, s);

    // Waves and wind act for the whole tick as they are in its middle; what is stiff is worked out in every
    // stage.
    const HeadingFrame frame({}, s.motion.heading_rad);
    const NorthEast middle = s.motion.position() + 0.5 * kTick_s * ground;
    const double middleHeading_rad = s.motion.heading_rad + 0.5 * kTick_s * s.motion.yawRate_radps;
    const WaveEffect waves = ship.dynamics.waveLoad().at(state.weather.sea, environment.waves, middle,
                                                         middleHeading_rad, world.area.shelterFactor(middle));
    Load slow = windLoad(ship.vessel.windage, ship.vessel.hull.lengthOverall_m, environment.wind,
                         s.motion.heading_rad, frame.vectorInBody(ground));
    for (std::size_t k = 0; k < ship.anchorCount(); ++k) {
        slow = slow + anchorLoad(ship.vessel.groundTackle.anchors[k], s.anchors[k], s.motion);
    }
    Obstacles obstacles;
    findObstacles(world.area, ship.hull, s.motion, obstacles);
    addShips(world, state, index, obstacles);
    const bool nearGround = s.underKeel_m < kGroundNear_m;
    s.motion = rk4Step(s.motion, kTick_s, [&](const ShipMotion& m) {
        Load load = slow;
        for (std::size_t k = 0; k < ship.lines.size(); ++k) {
            load = load + lineLoad(ship.vessel.mooring, ship.lines[k], s.lines[k], m, current);
        }
        if (!obstacles.empty()) load = load + contactLoad(obstacles, ship.hull, m, current);
        if (nearGround) load = load + groundLoad(world.area, ship.keel, m, environment.tide_m, current);
        return ship.dynamics.derivative(m, actuators, load, waves, current);
    });
    if (const std::int32_t component = notFinite(s.motion); component >= 0) {
        state.stopped = true;
        Event e;
        e.tick = state.tick;
        e.kind = EventKind::Stopped;
        e.ship = static_cast<std::uint8_t>(index);
        e.index = component;
        events.push_back(e);
        return;
    }

    constexpr double kGpsMean_s = 15.0;  // over a wave or two: a swell surges a ship by half a knot
    s.shownOverGround_mps =
        s.shownOverGround_mps + (kTick_s / kGpsMean_s) * (overGround_mps(s, current) - s.shownOverGround_mps);
    for (std::size_t k = 0; k < ship.lines.size(); ++k) {
        workLine(ship.vessel.mooring, ship.lines[k], s.lines[k], s.motion, kTick_s);
    }
    for (std::size_t k = 0; k < ship.anchorCount(); ++k) {
        const AnchorGround under{world.area.depth_m(s.motion.position()) + environment.tide_m,
                                 world.area.holdingRatio};
        workAnchor(ship.vessel.groundTackle.anchors[k], s.anchors[k], under, s.motion, kTick_s);
    }
    if (!obstacles.empty()) {
        reportContacts(findTouches(obstacles, ship.hull, s.motion, current), state, index, events);
    }
    reportGround(state, index, underKeel(world.area, ship.keel, s.motion, environment.tide_m).clearance_m,
                 events);
}

}  // namespace sagara::core
