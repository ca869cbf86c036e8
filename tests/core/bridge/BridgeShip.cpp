#include "BridgeShip.h"

#include <map>
#include <stdexcept>

#include "core/motion/RungeKutta.h"
#include "tests/support/Assets.h"

namespace sagara::core::test {

const OwnShip& shippedShip(const std::string& vesselId) {
    static std::map<std::string, OwnShip> ships;
    const auto known = ships.find(vesselId);
    if (known != ships.end()) return known->second;
    auto vessel = loadVessel(vesselId, sagara::test::readAsset("vessels/" + vesselId + ".json"));
    if (!vessel) throw std::runtime_error(vessel.error().text());
    return ships.try_emplace(vesselId, "own", "Own", std::move(vessel).value()).first->second;
}

OwnShipState underWay(const OwnShip& ship, TelegraphStep step) {
    OwnShipState state = startOf(ship);
    const double shaft_rps = ship.vessel.propulsion.telegraph_rps[static_cast<std::size_t>(step)];
    obey(ship, state, TelegraphOrder{kAllShafts, step});
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) state.shafts[i].speed_rps = shaft_rps;
    state.motion.surge_mps = shaft_rps * ship.advancePerRev_m;
    state.shownOverGround_mps = {state.motion.surge_mps, 0.0};
    return state;
}

NorthEast BridgeShip::overGround_mps() const {
    const HeadingFrame frame({}, state.motion.heading_rad);
    return frame.vector({state.motion.surge_mps, state.motion.sway_mps}) + current;
}

double BridgeShip::alongGround_mps() const {
    return dot(overGround_mps(), unitVector(state.motion.heading_rad));
}

void BridgeShip::tick() {
    runPilot(script, path, ship, state, kTick_s);
    state.steering.order_rad =
        steerAutopilot_rad(ship, path, state.motion, state.autopilot, state.steering.order_rad, kTick_s);
    const Actuators actuators = runMachinery(ship, state, kTick_s);
    Load load;
    for (std::size_t k = 0; k < ship.anchorCount(); ++k)
        load = load + anchorLoad(ship.vessel.groundTackle.anchors[k], state.anchors[k], state.motion);
    state.motion = rk4Step(state.motion, kTick_s, [&](const ShipMotion& m) {
        return ship.dynamics.derivative(m, actuators, load, current);
    });
    constexpr double kGpsMean_s = 15.0;
    state.shownOverGround_mps =
        state.shownOverGround_mps + (kTick_s / kGpsMean_s) * (overGround_mps() - state.shownOverGround_mps);
    state.underKeel_m = depth_m - ship.vessel.hull.draught_m;
    for (std::size_t k = 0; k < ship.anchorCount(); ++k) {
        workAnchor(ship.vessel.groundTackle.anchors[k], state.anchors[k], {depth_m, 1.0}, state.motion,
                   kTick_s);
    }
    time_s += kTick_s;
}

RoutePath pathOf(const std::vector<NorthEast>& points, double radius_m) {
    Route route;
    for (const NorthEast p : points) {
        Route::Waypoint w;
        w.position = p;
        w.turnRadius_m = radius_m;
        route.waypoints.push_back(w);
    }
    return RoutePath(route);
}

}  // namespace sagara::core::test
