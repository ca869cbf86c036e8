#include "core/motion/TransferShip.h"

#include <algorithm>
#include <cmath>

#include "core/motion/CrossFlow.h"

namespace sagara::core {
namespace {

/// Of the reference speed: below, the time constants stand still, or they would grow without end.
constexpr double kSlowest = 0.1;

}  // namespace

TransferShip::TransferShip(const TransferModel& model, const Vessel& vessel)
    : m_model(model), m_hull(vessel.hull), m_propellers(propellersOf(vessel.propulsion)) {}

TransferShip::Pace TransferShip::paceAt(double surge_mps) const {
    if (!m_model.scalesWithSpeed)
        return {m_model.gain_perS, m_model.timeConstant_s, m_model.swayTimeConstant_s, m_model.cubic_s2, 0.0};
    const double ratio = surge_mps / m_model.referenceSpeed_mps;
    const double pace = std::max(std::abs(ratio), kSlowest);
    return {m_model.gain_perS * ratio, m_model.timeConstant_s / pace, m_model.swayTimeConstant_s / pace,
            m_model.cubic_s2 / (pace * pace),
            std::clamp(2.0 * (1.0 - std::abs(ratio) / (2.0 * kSlowest)), 0.0, 1.0)};
}

double TransferShip::thrust_N(double surge_mps, const Actuators& actuators) const {
    double sum_N = 0.0;
    for (std::size_t i = 0; i < m_propellers.size(); ++i) {
        const PropellerForce force = m_propellers[i].behindHull(actuators.shaft_rps[i], actuators.pitch[i],
                                                                surge_mps, m_hull.waterDensity_kgpm3);
        sum_N += (1.0 - m_propellers[i].unit().thrustDeduction) * force.thrust_N;
    }
    return sum_N;
}

double TransferShip::turningLoss_kg() const {
    const double mass_kg = m_hull.mass_kg();
    switch (m_model.turningLoss) {
        case TransferModel::TurningLoss::None:
            return -mass_kg;
        case TransferModel::TurningLoss::Printed:
            return m_model.surgeFromTurn_kg - 2.0 * mass_kg;  // -(M - X_vr) in all
        case TransferModel::TurningLoss::Corrected:
            break;
    }
    return m_model.surgeFromTurn_kg;
}

HullForces TransferShip::hullForces(const ShipMotion& m, const Actuators& actuators,
                                    double /*depth_m*/) const {
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps;
    const Pace pace = paceAt(u);
    const double steered_radps = pace.gain_perS * actuators.rudder_rad;
    const double resisted_radps = r * (m_model.linear + pace.cubic_s2 * r * r);
    HullForces f;
    f.propeller.surge_N = thrust_N(u, actuators);
    f.rudder.sway_N = swayMass_kg() * m_model.swayGain_m * steered_radps / pace.sway_s;
    f.rudder.yaw_Nm = yawInertia_kgm2() * steered_radps / pace.yaw_s;
    f.hull = pace.nearRest * crossFlowDrag(m_hull, m_model.crossFlowDrag, v, r);
    f.hull.surge_N += turningLoss_kg() * v * r - m_model.resistance_kgpm * u * std::abs(u);
    f.hull.sway_N += swayMass_kg() * (m_model.swayGain_m * (r - resisted_radps) - v) / pace.sway_s;
    f.hull.yaw_Nm -= yawInertia_kgm2() * resisted_radps / pace.yaw_s;
    return f;
}

Load TransferShip::forceFor(const ShipMotion& m, const ShipMotion& rate, double /*depth_m*/) const {
    Load f;
    f.surge_N = surgeMass_kg() * rate.surge_mps - m_hull.mass_kg() * m.sway_mps * m.yawRate_radps;
    f.sway_N = swayMass_kg() * rate.sway_mps;
    f.yaw_Nm = yawInertia_kgm2() * rate.yawRate_radps;
    return f;
}

PlanarAcceleration TransferShip::acceleration(const ShipMotion& m, const Actuators& actuators,
                                              const Load& external, double depth_m) const {
    const HullForces own = hullForces(m, actuators, depth_m);
    const Load f = own.hull + own.rudder + own.propeller + external;
    PlanarAcceleration a;
    a.surge_mps2 = (f.surge_N + m_hull.mass_kg() * m.sway_mps * m.yawRate_radps) / surgeMass_kg();
    a.sway_mps2 = f.sway_N / swayMass_kg();
    a.yaw_radps2 = f.yaw_Nm / yawInertia_kgm2();
    return a;
}

}  // namespace sagara::core
