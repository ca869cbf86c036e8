#include "core/exercise/MoveShip.h"

#include <algorithm>
#include <cmath>

#include "core/bridge/Pilot.h"
#include "core/exercise/BowWatch.h"
#include "core/exercise/Observe.h"
#include "core/exercise/TickLoads.h"
#include "core/motion/RungeKutta.h"

namespace sagara::core {
namespace {

constexpr double kContactNoise_mps = 0.03;                   // softer touches are not reported
constexpr std::int64_t kNewContact_ticks = kTicksPerSecond;  // apart this long, a touch is a new one

Actuators workShip(const World& world, const OwnShip& ship, OwnShipState& s) {
    runPilot(world.pilot, world.path, ship, s, kTick_s);
    s.steering.order_rad =
        steerAutopilot_rad(ship, world.path, s.motion, s.autopilot, s.steering.order_rad, kTick_s);
    return runMachinery(ship, s, kTick_s);
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

void moveShip(const World& world, State& state, std::size_t index, const TickEnvironment& environment,
              std::vector<Event>& events) {
    const OwnShip& ship = *world.ships[index];
    OwnShipState& s = state.ships[index];
    const Actuators actuators = workShip(world, ship, s);
    const TickLoads loads(world, state, index, environment, actuators);
    const NorthEast current = loads.current();
    const MovingShip after = rk4Step(MovingShip{s.motion, s.water}, kTick_s,
                                     [&](const MovingShip& m) { return loads.rate(m, actuators); });
    s.motion = after.motion;
    s.water = after.water;
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
        const AnchorGround under{world.area.depth_m(s.motion.position()) + environment.water.tide_m,
                                 world.area.holdingRatio};
        workAnchor(ship.vessel.groundTackle.anchors[k], s.anchors[k], under, s.motion, kTick_s);
    }
    if (!loads.obstacles().empty()) {
        reportContacts(findTouches(loads.obstacles(), ship.hull, s.motion, current), state, index, events);
    }
    watchBow(world, state, index, environment, events);
    reportGround(state, index,
                 underKeel(world.area, ship.keel, s.motion, environment.water.tide_m).clearance_m, events);
}

}  // namespace sagara::core
