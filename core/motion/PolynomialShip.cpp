#include "core/motion/PolynomialShip.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/CrossFlow.h"
#include "core/motion/RaceDrive.h"
#include "core/motion/SmoothStep.h"

namespace sagara::core {
PolynomialShip::PolynomialShip(const PolynomialModel& model, const Vessel& vessel)
    : m_model(model),
      m_hull(vessel.hull),
      m_propellers(propellersOf(vessel.propulsion)),
      m_steering(vessel.steering),
      m_rows(model, vessel),
      m_mass_kg(m_rows.force_kgpm() * m_rows.length_m()),
      m_firstMoment_kgm(m_mass_kg * m_rows.length_m()),
      m_inertia_kgm2(m_firstMoment_kgm * m_rows.length_m()),
      m_deepWater(inertiaAt(0.0)) {}

PolynomialShip::Inertia PolynomialShip::inertiaAt(double z) const {
    const PolynomialModel& k = m_model;
    Inertia inertia;
    inertia.surge_kg = m_mass_kg * (k.mass - k.Xudot - z * k.XudotDepth);
    Eigen::Matrix3d mass;
    mass << m_mass_kg * (k.mass - k.Yvdot - z * k.YvdotDepth), -m_firstMoment_kgm * (k.mass * k.zG + k.Ypdot),
        m_firstMoment_kgm * (k.mass * k.xG - k.Yrdot),  //
        -m_firstMoment_kgm * (k.mass * k.zG + k.Kvdot), m_inertia_kgm2 * (k.Ixx.value_or(1.0) - k.Kpdot),
        -m_inertia_kgm2 * k.Krdot,  //
        m_firstMoment_kgm * (k.mass * k.xG - k.Nvdot), -m_inertia_kgm2 * k.Npdot,
        m_inertia_kgm2 * (k.Izz - k.Nrdot - z * k.NrdotDepth);
    const Eigen::Matrix3d inverse = mass.inverse();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            inertia.lateral[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = mass(i, j);
            inertia.inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = inverse(i, j);
        }
    }
    return inertia;
}

double PolynomialShip::publishedShare(double surge_mps) const {
    if (!m_model.lift) return 1.0;
    return smoothStep(m_model.lift->extensionBelow_mps, m_model.lift->holdsFrom_mps, surge_mps);
}

HullForces PolynomialShip::hullForces(const ShipMotion& m, const Actuators& actuators, double depth_m) const {
    const double published = publishedShare(m.surge_mps);
    HullForces f = m_rows.at(m, actuators, depth_m, published);
    if (published < 1.0) {
        f.hull = f.hull + (1.0 - published) *
                              crossFlowDrag(m_hull, m_model.lift->crossFlowDrag, m.sway_mps, m.yawRate_radps);
    }
    if (ownsRoll()) {
        f.hull.roll_Nm -= m_hull.waterDensity_kgpm3 * kGravity_mps2 * m_hull.metacentricHeight_m *
                          m_hull.displacement_m3 * m.roll_rad;
    }
    if (m_model.lift) {
        f.rudder = f.rudder + rudderLoad(m, actuators);
        f.propeller = f.propeller + propulsionLoad(m, actuators);
    }
    if (m_model.balanced) f.propeller = f.propeller + balancedLoad(m, actuators);
    if (m_model.race) {
        const HullForces race =
            raceDriveForces(*m_model.race, m_rows.length_m(), m_hull.waterDensity_kgpm3, m, actuators);
        f.rudder = f.rudder + race.rudder;
        f.propeller = f.propeller + race.propeller;
    }
    return f;
}

Load PolynomialShip::balancedLoad(const ShipMotion& m, const Actuators& actuators) const {
    Load sum;
    for (std::size_t i = 0; i < m_propellers.size(); ++i) {
        const Propeller& propeller = m_propellers[i];
        const auto thrust = [&](double shaft_rps, double pitch) {
            return propeller.behindHull(shaft_rps, pitch, m.surge_mps, m_hull.waterDensity_kgpm3).thrust_N;
        };
        const double more_N =
            (1.0 - propeller.unit().thrustDeduction) *
            (thrust(actuators.shaft_rps[i], actuators.pitch[i]) - thrust(m_model.balanced->shaft_rps, 1.0));
        sum.surge_N += more_N;
        sum.yaw_Nm -= propeller.unit().position.y_m * more_N;
    }
    return sum;
}

double PolynomialShip::thrust_N(std::size_t shaft, const Actuators& actuators, double surge_mps) const {
    const Propeller& propeller = m_propellers[shaft];
    const double shaft_rps = actuators.shaft_rps[shaft];
    const double ratio = shaft_rps / m_model.lift->shaft_rps;
    const double published_N =
        m_model.lift->thrust_N / static_cast<double>(m_propellers.size()) * ratio * ratio;
    const double share = shaft_rps >= 0.0 ? publishedShare(surge_mps) : 0.0;
    if (share == 1.0) return published_N;
    const double open_N =
        (1.0 - propeller.unit().thrustDeduction) *
        propeller.behindHull(shaft_rps, actuators.pitch[shaft], surge_mps, m_hull.waterDensity_kgpm3)
            .thrust_N;
    return share * published_N + (1.0 - share) * open_N;
}

Load PolynomialShip::propulsionLoad(const ShipMotion& m, const Actuators& actuators) const {
    Load sum;
    for (std::size_t i = 0; i < m_propellers.size(); ++i) {
        const double thrust = thrust_N(i, actuators, m.surge_mps);
        sum.surge_N += thrust;
        sum.yaw_Nm -= m_propellers[i].unit().position.y_m * thrust;
    }
    return sum;
}

Load PolynomialShip::rudderLoad(const ShipMotion& m, const Actuators& actuators) const {
    const double u = m.surge_mps, v = m.sway_mps, density = m_hull.waterDensity_kgpm3;
    const double published = publishedShare(u);
    const double angle_rad =
        std::clamp(actuators.rudder_rad, -m_steering.stallAngle_rad, m_steering.stallAngle_rad);
    constexpr double kAsternEffect = 0.5;  // flow on the trailing edge, hull in front of it
    const double own = u >= 0.0 ? u * u : -kAsternEffect * u * u;
    double force_N = 0.0;
    for (const BodyPoint& rudder : m_steering.rudders) {
        double inflow2 = published * (u * u + v * v) + (1.0 - published) * own;
        if (published < 1.0) {
            // the propeller before this rudder: the one nearest to it across the ship
            std::size_t before = 0;
            for (std::size_t i = 1; i < m_propellers.size(); ++i) {
                if (std::abs(m_propellers[i].unit().position.y_m - rudder.y_m) <
                    std::abs(m_propellers[before].unit().position.y_m - rudder.y_m)) {
                    before = i;
                }
            }
            const Propeller& propeller = m_propellers[before];
            const double thrust =
                propeller.behindHull(actuators.shaft_rps[before], actuators.pitch[before], u, density)
                    .thrust_N;
            inflow2 += (1.0 - published) * m_steering.raceShare *
                       addedRaceSquared(propeller.unit(), thrust, density);
        }
        force_N += 0.5 * density * m_steering.areaEach_m2 * m_steering.liftSlope_perRad * angle_rad * inflow2;
    }
    return {.sway_N = -force_N,
            .roll_Nm = m_model.lift->rudderRollLever_m * force_N,
            .yaw_Nm = m_model.lift->rudderYawLever_m * force_N};
}

Load PolynomialShip::turningLoad(const ShipMotion& m) const {
    if (m_model.turningInTerms) return {};
    const PolynomialModel& k = m_model;
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps, p = m.rollRate_radps;
    const double mass_kg = k.mass * m_mass_kg, forward_kgm = k.mass * k.xG * m_firstMoment_kgm,
                 down_kgm = k.mass * k.zG * m_firstMoment_kgm;
    return {.surge_N = mass_kg * v * r + forward_kgm * r * r - down_kgm * p * r,
            .sway_N = -mass_kg * u * r,
            .roll_Nm = down_kgm * u * r,
            .yaw_Nm = -forward_kgm * u * r};
}

Load PolynomialShip::forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const {
    const Inertia inertia = inertiaIn(depth_m);
    const std::array<double, 3> a{rate.sway_mps, rate.rollRate_radps, rate.yawRate_radps};
    const auto row = [&](std::size_t i) {
        return inertia.lateral[i][0] * a[0] + inertia.lateral[i][1] * a[1] + inertia.lateral[i][2] * a[2];
    };
    const Load turning = turningLoad(m);
    return {.surge_N = inertia.surge_kg * rate.surge_mps - turning.surge_N,
            .sway_N = row(0) - turning.sway_N,
            .yaw_Nm = row(2) - turning.yaw_Nm};
}

PlanarAcceleration PolynomialShip::acceleration(const ShipMotion& m, const Actuators& actuators,
                                                const Load& external, double depth_m) const {
    const HullForces own = hullForces(m, actuators, depth_m);
    const Load f = own.hull + own.rudder + own.propeller + turningLoad(m) + external;
    const Inertia inertia = inertiaIn(depth_m);
    const std::array<double, 3> lateral{f.sway_N, ownsRoll() ? f.roll_Nm : 0.0, f.yaw_Nm};
    const auto row = [&](std::size_t i) {
        return inertia.inverse[i][0] * lateral[0] + inertia.inverse[i][1] * lateral[1] +
               inertia.inverse[i][2] * lateral[2];
    };
    return {f.surge_N / inertia.surge_kg, row(0), row(1), row(2), 0.0, 0.0};
}

}  // namespace sagara::core
