#include "core/bridge/OwnShip.h"

#include <algorithm>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"

namespace sagara::core {
namespace {

/// Runs the ship half ahead in calm water until her speed is steady.
double advancePerRevolution_m(const Vessel& vessel, const ShipDynamics& dynamics) {
    const double shaft_rps =
        vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::HalfAhead)];
    Actuators actuators;
    actuators.shaft_rps.fill(shaft_rps);
    ShipMotion m;
    constexpr double kStep_s = 0.5, kLongest_s = 3600.0;
    double before_mps = -1.0;
    for (double t = 0.0; t < kLongest_s && m.surge_mps - before_mps > 1e-5; t += kStep_s) {
        before_mps = m.surge_mps;
        m = rk4Step(m, kStep_s,
                    [&](const ShipMotion& x) { return dynamics.derivative(x, actuators, {}, {}); });
        m.sway_mps = m.yawRate_radps = 0.0;  // held on a straight course
    }
    return m.surge_mps / shaft_rps;
}

/// Half ahead with a little rudder for a dozen lengths: the heading follows K (t - T) once the turn is
/// steady.
TurningIndices turningIndices(const Vessel& vessel, const ShipDynamics& dynamics, double advancePerRev_m) {
    const double shaft_rps =
        vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::HalfAhead)];
    Actuators actuators;
    actuators.shaft_rps.fill(shaft_rps);
    actuators.rudder_rad = 5.0 * kDegree_rad;
    if (vessel.steering.rudders.empty()) steerDrives(vessel.propulsion, actuators.rudder_rad, actuators);
    ShipMotion m;
    m.surge_mps = advancePerRev_m * shaft_rps;
    constexpr double kLengths = 12.0, kSteps = 600.0;
    const double pace_s = vessel.hull.lengthBp_m / m.surge_mps, step_s = kLengths * pace_s / kSteps;
    for (int i = 0; i < static_cast<int>(kSteps); ++i) {
        m = rk4Step(m, step_s,
                    [&](const ShipMotion& x) { return dynamics.derivative(x, actuators, {}, {}); });
    }
    const double gain = m.yawRate_radps * pace_s / actuators.rudder_rad;
    const double lag = kLengths - m.heading_rad / (m.yawRate_radps * pace_s);
    return {std::clamp(gain, 0.1, 5.0), std::clamp(lag, 0.1, 10.0)};
}

/// A model says by what it does whether it knows shallow water.
bool feelsDepth(const Vessel& vessel, const ShipDynamics& dynamics) {
    ShipMotion m;
    m.surge_mps = 3.0;
    m.sway_mps = 0.3;
    m.yawRate_radps = m.surge_mps / vessel.hull.lengthBp_m / 5.0;
    const Load deep = dynamics.hullForces(m, {}).hull;
    const Load shallow = dynamics.hullForces(m, {}, 1.5 * vessel.hull.draught_m).hull;
    return deep.surge_N != shallow.surge_N || deep.sway_N != shallow.sway_N || deep.yaw_Nm != shallow.yaw_Nm;
}

}  // namespace

OwnShip::OwnShip(std::string shipId, std::string shipName, Vessel shipVessel, std::string_view model,
                 std::shared_ptr<const SeaHull> seaHull)
    : id(std::move(shipId)),
      name(std::move(shipName)),
      vessel(std::move(shipVessel)),
      propellers(propellersOf(vessel.propulsion)),
      dynamics(vessel, model, std::move(seaHull)),
      hull(contactHull(vessel.hull, dynamics.lateralMass_kg())),
      bow(bowOf(vessel.hull)),
      keel(keelOf(vessel.hull, dynamics.heaveStiffness_Npm(), vessel.shallow.squat)),
      modelFeelsDepth(feelsDepth(vessel, dynamics)),
      advancePerRev_m(advancePerRevolution_m(vessel, dynamics)),
      turning(turningIndices(vessel, dynamics, advancePerRev_m)) {}

void holdMotions(std::uint8_t free, ShipMotion& v) {
    if (!isFree(free, FreeMotion::Surge)) v.surge_mps = 0.0;
    if (!isFree(free, FreeMotion::Sway)) v.sway_mps = 0.0;
    if (!isFree(free, FreeMotion::Heave)) v.heaveRate_mps = 0.0;
    if (!isFree(free, FreeMotion::Roll)) v.rollRate_radps = 0.0;
    if (!isFree(free, FreeMotion::Pitch)) v.pitchRate_radps = 0.0;
    if (!isFree(free, FreeMotion::Yaw)) v.yawRate_radps = 0.0;
}

Actuators actuatorsOf(const OwnShip& ship, const OwnShipState& state) {
    Actuators actuators;
    actuators.rudder_rad = state.steering.angle_rad;
    showShafts(ship.propellers, state.shafts, actuators);
    for (std::size_t i = 0; i < ship.thrusterCount(); ++i) actuators.thruster[i] = state.thrusters[i].share;
    return actuators;
}

Actuators runMachinery(const OwnShip& ship, OwnShipState& state, double dt_s) {
    const double rudder_rad = runSteeringGear(ship.vessel.steering, state.steering, dt_s);
    const double steered_rad = ship.vessel.steering.rudders.empty() ? state.steering.angle_rad : 0.0;
    runShafts(ship.propellers, state.shafts, state.motion, steered_rad, ship.vessel.hull.waterDensity_kgpm3,
              dt_s);
    for (std::size_t i = 0; i < ship.thrusterCount(); ++i)
        runThruster(ship.vessel.thrusters.units[i], state.thrusters[i], dt_s);
    Actuators actuators = actuatorsOf(ship, state);
    actuators.rudder_rad = rudder_rad;  // the mean of the tick
    return actuators;
}

OwnShipState startOf(const OwnShip& ship) {
    OwnShipState s;
    s.motion = ship.start;
    s.autopilot.setHeading_rad = ship.start.heading_rad;
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) {
        s.shafts[i].order_rps = s.shafts[i].speed_rps = ship.startShafts_rps[i];
    }
    for (std::size_t i = 0; i < ship.lines.size(); ++i) s.lines[i] = madeFast(ship.lines[i], ship.start);
    return s;
}

}  // namespace sagara::core
