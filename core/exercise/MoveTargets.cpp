#include "core/exercise/MoveTargets.h"

#include <algorithm>

#include "core/world/Hostile.h"

namespace sagara::core {
namespace {

const ShipMotion& nearestOwnShip(const State& state, NorthEast p) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < state.ships.size(); ++i) {
        if (distance(state.ships[i].motion.position(), p) <
            distance(state.ships[nearest].motion.position(), p))
            nearest = i;
    }
    return state.ships[nearest].motion;
}

}  // namespace

void moveTargets(const World& world, State& state, const WaterNow& water, double dt_s) {
    const bool pushes = std::any_of(world.ships.begin(), world.ships.end(),
                                    [](const auto& ship) { return ship->vessel.shallow.ships; });
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        TargetState& target = state.targets[i];
        if (!target.present) continue;
        const TargetLayout& layout = targetLayout(world, state, i);
        if (pushes) pushTarget(world, state, layout, target, water, dt_s);
        TargetIntent intent{target.heading_rad, 0.0};
        NorthEast drift = currentAt(world, water, target.position);
        if (target.underOrders()) {
            moveTarget(layout, target, followOrders(layout, target), drift, dt_s);
            continue;
        }
        switch (layout.behaviour) {
            case TargetBehaviour::Route:
            case TargetBehaviour::Circuit:
                intent = followRoute(layout, target);
                break;
            case TargetBehaviour::Hostile: {
                const ShipMotion& own = nearestOwnShip(state, target.position);
                intent = hostileIntent(layout, target, own.position(), own.heading_rad, own.surge_mps, dt_s);
                break;
            }
            case TargetBehaviour::Lying:
                drift = {};
                break;  // at anchor
            case TargetBehaviour::Course:
                intent = {layout.heading_rad, layout.route.front().speed_mps};
                break;
        }
        moveTarget(layout, target, intent, drift, dt_s);
    }
}

}  // namespace sagara::core
