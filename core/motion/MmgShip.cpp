#include "core/motion/MmgShip.h"

#include <cmath>

namespace sagara::core {

MmgShip::MmgShip(const MmgModel& model, const Vessel& vessel)
    : m_model(model),
      m_hull(vessel.hull),
      m_propulsion(vessel.propulsion),
      m_steering(vessel.steering),
      m_massScale_kg(0.5 * m_hull.waterDensity_kgpm3 * m_hull.lengthBp_m * m_hull.lengthBp_m *
                     m_hull.draught_m),
      m_mass_kg(m_hull.mass_kg()),
      m_yawInertia_kgm2(m_mass_kg * (model.inertia.yawGyradius_m * model.inertia.yawGyradius_m +
                                     model.inertia.xG_m * model.inertia.xG_m)) {
    const auto& units = m_propulsion.units;
    for (const BodyPoint& rudder : m_steering.rudders) {
        const auto across_m = [&](std::size_t i) { return std::abs(units[i].position.y_m - rudder.y_m); };
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < units.size(); ++i)
            if (across_m(i) < across_m(nearest)) nearest = i;
        m_before.push_back({nearest, across_m(nearest) < 0.5 * units[nearest].diameter_m});
    }
}

MmgPropeller MmgShip::propeller(std::size_t i, const ShipMotion& m, const Actuators& actuators) const {
    return mmgPropeller(m_model, m_hull, m_propulsion.units[i], actuators.shaft_rps[i], m,
                        mmgFlow(m_model.range, m_hull.lengthBp_m, m));
}

MmgRudderForce MmgShip::rudder(std::size_t i, const ShipMotion& m, const Actuators& actuators) const {
    const Before before = m_before[i];
    return mmgRudderForce(m_model, m_hull, m_steering, m_steering.rudders[i], actuators.rudder_rad,
                          m_propulsion.units[before.screw], propeller(before.screw, m, actuators),
                          before.inRace, m, mmgFlow(m_model.range, m_hull.lengthBp_m, m));
}

HullForces MmgShip::hullForces(const ShipMotion& m, const Actuators& actuators) const {
    HullForces f;
    f.hull = mmgHullForce(m_model, m_hull, m, mmgFlow(m_model.range, m_hull.lengthBp_m, m));
    for (std::size_t i = 0; i < m_steering.rudders.size(); ++i)
        f.rudder = f.rudder + rudder(i, m, actuators).load;
    for (std::size_t i = 0; i < m_propulsion.units.size(); ++i)
        f.propeller = f.propeller + propeller(i, m, actuators).load;
    return f;
}

Load MmgShip::forceFor(const ShipMotion& m, const ShipMotion& rate) const {
    const MmgInertia& k = m_model.inertia;
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps;
    const double mx = k.mx * m_massScale_kg, my = k.my * m_massScale_kg, moment = m_mass_kg * k.xG_m;
    const double Jz = k.Jz * m_massScale_kg * m_hull.lengthBp_m * m_hull.lengthBp_m;
    Load f;
    f.surge_N = (m_mass_kg + mx) * rate.surge_mps - (m_mass_kg + my) * v * r - moment * r * r;
    f.sway_N = (m_mass_kg + my) * rate.sway_mps + (m_mass_kg + mx) * u * r + moment * rate.yawRate_radps;
    f.yaw_Nm = (m_yawInertia_kgm2 + Jz) * rate.yawRate_radps + moment * (rate.sway_mps + u * r);
    return f;
}

PlanarAcceleration MmgShip::acceleration(const ShipMotion& m, const Actuators& actuators,
                                         const Load& external) const {
    const HullForces forces = hullForces(m, actuators);
    const Load still = forceFor(m, {});
    const Load f = forces.hull + forces.rudder + forces.propeller + external + -1.0 * still;
    const MmgInertia& k = m_model.inertia;
    const double moment = m_mass_kg * k.xG_m, sway_kg = m_mass_kg + k.my * m_massScale_kg;
    const double yaw_kgm2 = m_yawInertia_kgm2 + k.Jz * m_massScale_kg * m_hull.lengthBp_m * m_hull.lengthBp_m;
    const double determinant = sway_kg * yaw_kgm2 - moment * moment;
    PlanarAcceleration a;
    a.surge_mps2 = f.surge_N / (m_mass_kg + k.mx * m_massScale_kg);
    a.sway_mps2 = (yaw_kgm2 * f.sway_N - moment * f.yaw_Nm) / determinant;
    a.yaw_radps2 = (sway_kg * f.yaw_Nm - moment * f.sway_N) / determinant;
    return a;
}

}  // namespace sagara::core
