#pragma once

#include <string>
#include <vector>

#include "core/base/SimTime.h"
#include "core/bridge/OwnShip.h"
#include "core/bridge/Pilot.h"
#include "core/bridge/ShipOrders.h"

namespace sagara::core::test {

/// A shipped vessel, made once.
const OwnShip& shippedShip(const std::string& vesselId);
/// Under way at the speed of a telegraph step, or at rest at Stop, head north from the origin.
OwnShipState underWay(const OwnShip& ship, TelegraphStep step);

/// An own ship in deep open water, worked tick by tick as an exercise works her: pilot, autopilot, machinery,
/// motion, anchors.
class BridgeShip {
public:
    BridgeShip(const std::string& vesselId, TelegraphStep step)
        : ship(shippedShip(vesselId)), state(underWay(ship, step)) {}

    const OwnShip& ship;
    OwnShipState state;
    PilotScript script;
    RoutePath path;
    NorthEast current;
    double depth_m = 18.0;  ///< for anchors; the ship does not feel it
    double time_s = 0.0;

    ShipMotion& motion() { return state.motion; }
    const ShipMotion& motion() const { return state.motion; }
    NorthEast overGround_mps() const;
    double alongGround_mps() const;
    void tick();
    void run(double for_s) {
        for (double end_s = time_s + for_s; time_s < end_s;) tick();
    }
    /// `each` after every tick.
    template <typename Each>
    void run(double for_s, Each&& each) {
        for (double end_s = time_s + for_s; time_s < end_s;) {
            tick();
            each();
        }
    }
    template <typename Order>
    void order(const Order& given) {
        obey(ship, state, given);
    }
};

/// A path over these points with arcs of one radius.
RoutePath pathOf(const std::vector<NorthEast>& points, double radius_m);

}  // namespace sagara::core::test
