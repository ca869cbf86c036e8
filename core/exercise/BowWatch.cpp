#include "core/exercise/BowWatch.h"

namespace sagara::core {
namespace {

constexpr std::int64_t kEvery_ticks = 5;
constexpr double kEvery_s = static_cast<double>(kEvery_ticks) * kTick_s;
constexpr std::int64_t kQuiet_ticks = 15 * kTicksPerSecond;

Event bowEvent(const State& state, EventKind kind, std::size_t ship, NorthEast place, double value) {
    Event e;
    e.tick = state.tick;
    e.kind = kind;
    e.ship = static_cast<std::uint8_t>(ship);
    e.place = place;
    e.value = value;
    return e;
}

}  // namespace

void watchBow(const World& world, State& state, std::size_t index, const TickEnvironment& environment,
              std::vector<Event>& events) {
    const OwnShip& ship = *world.ships[index];
    if (state.tick % kEvery_ticks != 0 || !ship.dynamics.feelsWaves()) return;
    OwnShipState& s = state.ships[index];
    const HeadingFrame frame(s.motion.position(), s.motion.heading_rad);
    const auto rise = [&](double forward_m) {
        const NorthEast place = frame.point({forward_m, 0.0});
        const double factor = environment.water.waves.factorAt(place);
        return riseAt(s.motion, forward_m, factor * longElevation_m(environment.waves, place));
    };
    const Bow& bow = ship.bow;
    const auto told = [&](std::int64_t& last, EventKind kind, double forward_m, double value) {
        if (state.tick - last > kQuiet_ticks)
            events.push_back(bowEvent(state, kind, index, frame.point({forward_m, 0.0}), value));
        last = state.tick;
    };
    if (const double over_m = rise(bow.stem_m) - bow.freeboard_m; over_m > 0.0)
        told(s.bow.greenTick, EventKind::GreenWater, bow.stem_m, over_m);
    const double before_m = s.bow.forefootRise_m, now_m = rise(bow.forefoot_m);
    const double velocity_mps = (now_m - before_m) / kEvery_s;
    if (before_m < -bow.draught_m && now_m >= -bow.draught_m && velocity_mps > bow.slamThreshold_mps)
        told(s.bow.slamTick, EventKind::Slam, bow.forefoot_m, velocity_mps);
    s.bow.forefootRise_m = now_m;
}

}  // namespace sagara::core
