#include "core/motion/MmgShip.h"

#include <cmath>

#include "core/motion/AsternSideForce.h"
#include "core/motion/MmgShallow.h"
#include "core/vessel/Metacentre.h"

namespace sagara::core {

MmgShip::MmgShip(const MmgModel& model, const Vessel& vessel)
    : m_deep(model.parameters),
      m_astern(model.astern),
      m_hull(vessel.hull),
      m_screws(propellersOf(vessel.propulsion)),
      m_steering(vessel.steering),
      m_massScale_kg(0.5 * m_hull.waterDensity_kgpm3 * m_hull.lengthBp_m * m_hull.lengthBp_m *
                     m_hull.draught_m),
      m_mass_kg(m_hull.mass_kg()),
      m_yawInertia_kgm2(m_mass_kg * (m_deep.inertia.yawGyradius_m * m_deep.inertia.yawGyradius_m +
                                     m_deep.inertia.xG_m * m_deep.inertia.xG_m)),
      m_gravityDepth_m(gravityDepth_m(m_hull)) {
    if (vessel.planing) m_planing.emplace(*vessel.planing, m_hull);
    for (const BodyPoint& rudder : m_steering.rudders) {
        const auto across_m = [&](std::size_t i) {
            return std::abs(m_screws[i].unit().position.y_m - rudder.y_m);
        };
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < m_screws.size(); ++i)
            if (across_m(i) < across_m(nearest)) nearest = i;
        m_before.push_back({nearest, across_m(nearest) < 0.5 * m_screws[nearest].unit().diameter_m});
    }
}

MmgShip::Screws MmgShip::screws(const MmgParameters& p, const ShipMotion& m, const Actuators& a,
                                const MmgFlow& flow) const {
    Screws all;
    for (std::size_t i = 0; i < m_screws.size(); ++i)
        all[i] = mmgPropeller(p, m_hull, m_screws[i], orderOf(i, a), m, flow);
    return all;
}

ScrewOrder MmgShip::orderOf(std::size_t screw, const Actuators& a) {
    return {a.shaft_rps[screw], a.pitch[screw], a.azimuth_rad[screw]};
}

MmgRudderForce MmgShip::rudder(std::size_t i, const MmgParameters& p, const Screws& screws,
                               const ShipMotion& m, const Actuators& a, const MmgFlow& flow) const {
    const Before before = m_before[i];
    return mmgRudderForce(p, m_hull, m_steering, m_steering.rudders[i], a.rudder_rad,
                          m_screws[before.screw].unit(), screws[before.screw], before.inRace, m, flow);
}

MmgShip::Parts MmgShip::parts(const ShipMotion& m, const Actuators& actuators, double depth_m) const {
    const MmgParameters p = mmgInDepth(m_deep, m_hull, depth_m);
    const MmgFlow flow = mmgFlow(p.range, m_hull.lengthBp_m, m);
    Parts parts{screws(p, m, actuators, flow), {}};
    for (std::size_t i = 0; i < m_before.size(); ++i)
        parts.rudders.push_back(rudder(i, p, parts.screws, m, actuators, flow));
    return parts;
}

HullForces MmgShip::forces(const MmgParameters& p, const ShipMotion& m, const Actuators& actuators) const {
    const MmgFlow flow = mmgFlow(p.range, m_hull.lengthBp_m, m);
    const Screws running = screws(p, m, actuators, flow);
    HullForces f;
    f.hull = mmgHullForce(p, m_hull, m, flow);
    for (const MmgPropeller& screw : running) f.propeller = f.propeller + screw.load;
    for (std::size_t i = 0; i < m_screws.size(); ++i)
        f.propeller = f.propeller + asternSideForce(m_astern, m_hull, m_screws[i].unit(),
                                                    orderOf(i, actuators), m.surge_mps);
    for (std::size_t i = 0; i < m_before.size(); ++i)
        f.rudder = f.rudder + rudder(i, p, running, m, actuators, flow).load;
    return f;
}

HullForces MmgShip::hullForces(const ShipMotion& m, const Actuators& actuators, double depth_m) const {
    return forces(mmgInDepth(m_deep, m_hull, depth_m), m, actuators);
}

Load MmgShip::inertia(const MmgInertia& k, const ShipMotion& m, const ShipMotion& rate) const {
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps, L = m_hull.lengthBp_m;
    const double surge_kg = m_mass_kg + k.mx * m_massScale_kg, sway_kg = m_mass_kg + k.my * m_massScale_kg,
                 moment = m_mass_kg * k.xG_m;
    Load f;
    f.surge_N = surge_kg * rate.surge_mps - sway_kg * v * r - moment * r * r;
    f.sway_N = sway_kg * rate.sway_mps + surge_kg * u * r + moment * rate.yawRate_radps;
    f.yaw_Nm = (m_yawInertia_kgm2 + k.Jz * m_massScale_kg * L * L) * rate.yawRate_radps +
               moment * (rate.sway_mps + u * r);
    return f;
}

Load MmgShip::forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const {
    return inertia(mmgInDepth(m_deep, m_hull, depth_m).inertia, m, rate);
}

PlanarAcceleration MmgShip::acceleration(const ShipMotion& m, const Actuators& actuators,
                                         const Load& external, double depth_m) const {
    const MmgParameters p = mmgInDepth(m_deep, m_hull, depth_m);
    const MmgInertia& k = p.inertia;
    const HullForces own = forces(p, m, actuators);
    const Load f = own.hull + own.rudder + own.propeller + external + -1.0 * inertia(k, m, {});
    const double L = m_hull.lengthBp_m, moment = m_mass_kg * k.xG_m,
                 sway_kg = m_mass_kg + k.my * m_massScale_kg,
                 yaw_kgm2 = m_yawInertia_kgm2 + k.Jz * m_massScale_kg * L * L;
    const double determinant = sway_kg * yaw_kgm2 - moment * moment;
    PlanarAcceleration a;
    a.surge_mps2 = f.surge_N / (m_mass_kg + k.mx * m_massScale_kg);
    a.sway_mps2 = (yaw_kgm2 * f.sway_N - moment * f.yaw_Nm) / determinant;
    a.yaw_radps2 = (sway_kg * f.yaw_Nm - moment * f.sway_N) / determinant;
    const double turning_N = m_massScale_kg * k.mx * m.surge_mps * m.yawRate_radps;
    const double ofHull_N = own.hull.sway_N - turning_N;  // at rest in frame B
    const double floating_m = kLateralForceDepth * m_hull.draught_m;
    const double depth = m_planing ? m_planing->sideForceDepth_m(m.surge_mps, floating_m) : floating_m;
    const double added_N = m_massScale_kg * k.my * a.sway_mps2;
    a.heelAtBo_Nm = own.rudder.roll_Nm + own.propeller.roll_Nm - depth * ofHull_N;
    a.heel_Nm = a.heelAtBo_Nm + depth * added_N +
                m_gravityDepth_m * (ofHull_N - added_N + own.rudder.sway_N + own.propeller.sway_N);
    return a;
}

}  // namespace sagara::core
