#include "core/motion/SandaruwanShip.h"

#include <algorithm>
#include <cmath>

#include "core/motion/CrossFlow.h"

namespace sagara::core {
namespace {

constexpr double kSlowest = 0.1;  // of the reference speed

}  // namespace

SandaruwanShip::SandaruwanShip(const SandaruwanModel& model, const Vessel& vessel)
    : m_model(model), m_hull(vessel.hull), m_propellers(propellersOf(vessel.propulsion)) {}

SandaruwanShip::Pace SandaruwanShip::paceAt(double surge_mps) const {
    // As in `acceleration`, where the comments are.
    const double ratio = m_model.scalesWithSpeed ? surge_mps / m_model.referenceSpeed_mps : 1.0;
    const double pace = std::max(std::abs(ratio), kSlowest);
    const double rest = m_model.scalesWithSpeed
                            ? std::clamp(2.0 * (1.0 - std::abs(ratio) / (2.0 * kSlowest)), 0.0, 1.0)
                            : 0.0;
    return {ratio, m_model.gain_perS * (m_model.scalesWithSpeed ? ratio : 1.0), m_model.timeConstant_s / pace,
            m_model.swayTimeConstant_s / pace, rest};
}

double SandaruwanShip::thrust_N(double surge_mps, const Actuators& actuators) const {
    double sum_N = 0.0;
    for (std::size_t i = 0; i < m_propellers.size(); ++i) {
        const PropellerForce force = m_propellers[i].behindHull(actuators.shaft_rps[i], actuators.pitch[i],
                                                                surge_mps, m_hull.waterDensity_kgpm3);
        sum_N += (1.0 - m_propellers[i].unit().thrustDeduction) * force.thrust_N;
    }
    return sum_N;
}

HullForces SandaruwanShip::hullForces(const ShipMotion& m, const Actuators& actuators,
                                      double /*depth_m*/) const {
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps;
    const Pace pace = paceAt(u);
    HullForces f;
    f.propeller.surge_N = thrust_N(u, actuators);
    const double turning = pace.gain_perS * actuators.rudder_rad;
    f.rudder.sway_N = swayMass_kg() * m_model.swayGain_m * turning / pace.sway_s;
    f.rudder.yaw_Nm = yawInertia_kgm2() * turning / pace.yaw_s;
    f.hull = pace.nearRest * crossFlowDrag(m_hull, m_model.crossFlowDrag, v, r);
    f.hull.surge_N += m_model.surgeFromTurn_kg * v * r - m_model.resistance_kgpm * u * std::abs(u);
    f.hull.sway_N -= swayMass_kg() * v / pace.sway_s;
    f.hull.yaw_Nm -= yawInertia_kgm2() * r / pace.yaw_s;
    return f;
}

Load SandaruwanShip::forceFor(const ShipMotion& m, const ShipMotion& rate, double /*depth_m*/) const {
    const double mass_kg = m_hull.mass_kg();
    Load f;
    f.surge_N = mass_kg * (1.0 + m_model.surgeAddedMassRatio) * rate.surge_mps -
                mass_kg * m.sway_mps * m.yawRate_radps;
    f.sway_N = swayMass_kg() * rate.sway_mps;
    f.yaw_Nm = yawInertia_kgm2() * rate.yawRate_radps;
    return f;
}

PlanarAcceleration SandaruwanShip::acceleration(const ShipMotion& m, const Actuators& actuators,
                                                const Load& external, double /*depth_m*/) const {
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps;
    const double mass_kg = m_hull.mass_kg();
    // Below a tenth of the reference speed the time constants stand still, or they would grow without end.
    const double speedRatio = m_model.scalesWithSpeed ? u / m_model.referenceSpeed_mps : 1.0;
    const double pace = std::max(std::abs(speedRatio), kSlowest);
    const double gain_perS = m_model.gain_perS * (m_model.scalesWithSpeed ? speedRatio : 1.0);

    // Yaw damping r/tau fades with speed; near rest the hull's cross flow stands in for it and for sway.
    const double nearRest = std::clamp(2.0 * (1.0 - std::abs(speedRatio) / (2.0 * kSlowest)), 0.0, 1.0);
    const Load drag =
        m_model.scalesWithSpeed ? nearRest * crossFlowDrag(m_hull, m_model.crossFlowDrag, v, r) : Load{};
    const double yawInertia_kgm2 = mass_kg * m_hull.pitchGyradius_m * m_hull.pitchGyradius_m;

    PlanarAcceleration a;
    a.surge_mps2 = (thrust_N(u, actuators) + external.surge_N - m_model.resistance_kgpm * u * std::abs(u) +
                    (mass_kg + m_model.surgeFromTurn_kg) * v * r) /
                   (mass_kg * (1.0 + m_model.surgeAddedMassRatio));
    const double tau_s = m_model.timeConstant_s / pace;
    const double steered_radps2 = (gain_perS * actuators.rudder_rad - r) / tau_s;
    a.yaw_radps2 = steered_radps2 +
                   (external.yaw_Nm + drag.yaw_Nm) / (yawInertia_kgm2 * (1.0 + m_model.yawAddedInertiaRatio));
    a.sway_mps2 =
        (m_model.swayGain_m * (tau_s * steered_radps2 + r) - v) / (m_model.swayTimeConstant_s / pace) +
        (external.sway_N + drag.sway_N) / (mass_kg * (1.0 + m_model.swayAddedMassRatio));
    return a;
}

}  // namespace sagara::core
