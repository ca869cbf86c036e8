#include "core/exercise/LocalWater.h"

#include <algorithm>
#include <cmath>

#include "core/motion/BankLoad.h"
#include "core/motion/ShallowHull.h"
#include "core/world/Bank.h"

namespace sagara::core {
namespace {

SlenderShip slender(const OwnShip& ship, const ShipMotion& m) {
    const Hull& hull = ship.vessel.hull;
    return {m.position(),    m.heading_rad, m.surge_mps,         m.sway_mps,
            hull.lengthBp_m, hull.beam_m,   hull.displacement_m3};
}

SlenderShip slender(const TargetLayout& layout, const TargetState& t) {
    return {t.position,
            t.heading_rad,
            t.speed_mps,
            0.0,
            layout.length_m,
            layout.beam_m,
            layout.mass_kg() / kSeaWaterDensity_kgpm3};
}

Load passingLoad(const World& world, const State& state, std::size_t index, double depth_m) {
    const OwnShip& own = *world.ships[index];
    const double density = own.vessel.hull.waterDensity_kgpm3;
    depth_m = std::max(depth_m, own.vessel.hull.draught_m);  // aground too
    const SlenderShip self = slender(own, state.ships[index].motion);
    Load load;
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        if (i == index) continue;
        load =
            load + interactionLoad(self, slender(*world.ships[i], state.ships[i].motion), depth_m, density);
    }
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetState& t = state.targets[i];
        if (!t.present) continue;
        load = load + interactionLoad(self, slender(targetLayout(world, state, i), t), depth_m, density);
    }
    return load;
}

}  // namespace

WaterNow::WaterNow(const World& world, const State& state, SimTime time)
    : uniform(state.weather.now.current),
      tide_m(world.tide.height_m(time)),
      waves(world.area, state.weather.sea.systems, tide_m) {
    if (!world.streams.empty()) clock = tidalClockAt(world.highWaters, time);
}

NorthEast currentAt(const World& world, const WaterNow& now, NorthEast p) {
    return world.streams.empty() ? now.uniform : now.uniform + world.streams.at(p, now.clock);
}

NorthEast currentAt(const World& world, const State& state, NorthEast p) {
    if (world.streams.empty()) return state.weather.now.current;
    return state.weather.now.current + world.streams.at(p, tidalClockAt(world.highWaters, state.time()));
}

Load streamLoad(const World& world, const WaterNow& now, const OwnShip& ship, const ShipMotion& m,
                double depth_m) {
    const HeadingFrame frame(m.position(), m.heading_rad);
    const double half_m = 0.5 * ship.vessel.hull.lengthBp_m;
    const auto change = [&](BodyPoint towards) {
        const NorthEast ahead = currentAt(world, now, frame.point(towards));
        const NorthEast behind = currentAt(world, now, frame.point({-towards.x_m, -towards.y_m}));
        return frame.vectorInBody(ahead - behind);
    };
    const BodyPoint along = change({half_m, 0.0}), across = change({0.0, half_m});
    const double perMetre = -ship.vessel.hull.mass_kg() / (2.0 * half_m);
    Load load{.surge_N = perMetre * (m.surge_mps * along.x_m + m.sway_mps * across.x_m),
              .sway_N = perMetre * (m.surge_mps * along.y_m + m.sway_mps * across.y_m)};
    ShipMotion turned = m;
    turned.yawRate_radps -= along.y_m / (2.0 * half_m);
    const Actuators still;
    const Load with = ship.dynamics.hullForces(turned, still, depth_m).hull;
    const Load without = ship.dynamics.hullForces(m, still, depth_m).hull;
    return load + with + -1.0 * without;
}

Load confinedLoad(const World& world, const State& state, std::size_t index, const WaterNow& now,
                  const Actuators& actuators, double depth_m) {
    const OwnShip& ship = *world.ships[index];
    const ShallowWater& asked = ship.vessel.shallow;
    const Hull& hull = ship.vessel.hull;
    const ShipMotion& m = state.ships[index].motion;
    Load load;
    if (asked.hull && !ship.modelFeelsDepth) {
        ShipMotion drift = m;
        drift.yawRate_radps = 0.0;
        const Load deep = ship.dynamics.hullForces(m, actuators).hull;
        const Load deepDrift = ship.dynamics.hullForces(drift, actuators).hull;
        load = load + shallowHullLoad(hull, deep, deepDrift, m.surge_mps, depth_m);
    }
    if (asked.bank) {
        const double eta = bankAsymmetry(world.area, m.position(), m.heading_rad, hull.lengthBp_m,
                                         hull.beam_m, depth_m, now.tide_m);
        load = load + bankLoad(hull, eta, m.surge_mps, depth_m);
    }
    if (asked.ships) load = load + passingLoad(world, state, index, depth_m);
    return load;
}

void pushTarget(const World& world, const State& state, const TargetLayout& layout, TargetState& target,
                const WaterNow& now, double dt_s) {
    const SlenderShip self = slender(layout, target);
    Load load;
    double depth_m = -1.0;  // looked up for the first ship that is near enough
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        const OwnShip& own = *world.ships[i];
        if (!own.vessel.shallow.ships) continue;
        const SlenderShip other = slender(own, state.ships[i].motion);
        if (distance(self.position, other.position) > 2.0 * (self.length_m + other.length_m)) continue;
        if (depth_m < 0.0)
            depth_m = std::max(world.area.depth_m(target.position) + now.tide_m, layout.draught_m);
        load = load + interactionLoad(self, other, depth_m, kSeaWaterDensity_kgpm3);
    }
    if (depth_m < 0.0) return;
    // Added mass 5 % in surge, as much again in yaw; gyradius a quarter of her length.
    const double mass_kg = layout.mass_kg();
    target.speed_mps += dt_s * load.surge_N / (1.05 * mass_kg);
    target.yawRate_radps += dt_s * load.yaw_Nm * 8.0 / (mass_kg * layout.length_m * layout.length_m);
}

}  // namespace sagara::core
