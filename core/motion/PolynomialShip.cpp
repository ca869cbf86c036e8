#include "core/motion/PolynomialShip.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/CrossFlow.h"

namespace sagara::core {
namespace {

constexpr std::size_t kFactors = 11;

/// Values of PolynomialTerm::Factor, in its order.
std::array<double, kFactors> factorValues(const ShipMotion& m) {
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps, p = m.rollRate_radps, phi = m.roll_rad;
    return {1.0, u, v, r, p, phi, std::abs(u), std::abs(v), std::abs(r), std::abs(p), std::abs(phi)};
}

double smoothStep(double from, double to, double x) {
    const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

}  // namespace

PolynomialShip::PolynomialShip(const PolynomialModel& model, const Vessel& vessel)
    : m_model(model),
      m_hull(vessel.hull),
      m_propellers(propellersOf(vessel.propulsion)),
      m_steering(vessel.steering) {
    const PolynomialModel& k = m_model;
    Eigen::Matrix3d mass;
    mass << k.mass_kg - k.Yvdot, -(k.mass_kg * k.zG_m + k.Ypdot), k.mass_kg * k.xG_m - k.Yrdot,  //
        -(k.mass_kg * k.zG_m + k.Kvdot), k.rollInertia_kgm2 - k.Kpdot, -k.Krdot,                 //
        k.mass_kg * k.xG_m - k.Nvdot, -k.Npdot, k.yawInertia_kgm2 - k.Nrdot;
    const Eigen::Matrix3d inverse = mass.inverse();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            m_inverseMass[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = inverse(i, j);
    }
}

double PolynomialShip::publishedShare(double surge_mps) const {
    return smoothStep(m_model.extensionBelow_mps, m_model.holdsFrom_mps, surge_mps);
}

Load PolynomialShip::hullLoad(const ShipMotion& m) const {
    const auto value = factorValues(m);
    const double published = publishedShare(m.surge_mps);
    const double astern = m.surge_mps < 0.0 ? -1.0 : 1.0;
    Load sum;
    for (const PolynomialTerm& term : m_model.terms) {
        double product = (term.crossFlow ? published : 1.0) * (term.turnsAstern ? astern : 1.0);
        for (const auto factor : term.factors) product *= value[static_cast<std::size_t>(factor)];
        sum.surge_N += term.surge * product;
        sum.sway_N += term.sway * product;
        sum.roll_Nm += term.roll * product;
        sum.yaw_Nm += term.yaw * product;
    }
    if (published < 1.0) {
        sum = sum +
              (1.0 - published) * crossFlowDrag(m_hull, m_model.crossFlowDrag, m.sway_mps, m.yawRate_radps);
    }
    sum.roll_Nm -= m_hull.waterDensity_kgpm3 * kGravity_mps2 * m_hull.metacentricHeight_m *
                   m_hull.displacement_m3 * m.roll_rad;
    return sum;
}

double PolynomialShip::thrust_N(std::size_t shaft, const Actuators& actuators, double surge_mps) const {
    const Propeller& propeller = m_propellers[shaft];
    const double shaft_rps = actuators.shaft_rps[shaft];
    const double ratio = shaft_rps / m_model.publishedShaft_rps;
    const double published_N =
        m_model.publishedThrust_N / static_cast<double>(m_propellers.size()) * ratio * ratio;
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
            .roll_Nm = m_model.rudderRollLever_m * force_N,
            .yaw_Nm = m_model.rudderYawLever_m * force_N};
}

Load PolynomialShip::forceFor(const ShipMotion& m, const ShipMotion& rate, double /*depth_m*/) const {
    const PolynomialModel& k = m_model;
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps, p = m.rollRate_radps;
    Load f;
    f.surge_N =
        (k.mass_kg - k.Xudot) * rate.surge_mps - k.mass_kg * (v * r + k.xG_m * r * r - k.zG_m * p * r);
    f.sway_N = (k.mass_kg - k.Yvdot) * rate.sway_mps - (k.mass_kg * k.zG_m + k.Ypdot) * rate.rollRate_radps +
               (k.mass_kg * k.xG_m - k.Yrdot) * rate.yawRate_radps + k.mass_kg * u * r;
    f.yaw_Nm = (k.mass_kg * k.xG_m - k.Nvdot) * rate.sway_mps - k.Npdot * rate.rollRate_radps +
               (k.yawInertia_kgm2 - k.Nrdot) * rate.yawRate_radps + k.mass_kg * k.xG_m * u * r;
    return f;
}

PlanarAcceleration PolynomialShip::acceleration(const ShipMotion& m, const Actuators& actuators,
                                                const Load& external, double /*depth_m*/) const {
    const PolynomialModel& k = m_model;
    const double u = m.surge_mps, v = m.sway_mps, r = m.yawRate_radps, p = m.rollRate_radps;
    const Load f = hullLoad(m) + propulsionLoad(m, actuators) + rudderLoad(m, actuators) + external;
    const double surge_N = f.surge_N + k.mass_kg * (v * r + k.xG_m * r * r - k.zG_m * p * r);
    const std::array<double, 3> lateral{f.sway_N - k.mass_kg * u * r, f.roll_Nm + k.mass_kg * k.zG_m * u * r,
                                        f.yaw_Nm - k.mass_kg * k.xG_m * u * r};
    const auto row = [&](std::size_t i) {
        return m_inverseMass[i][0] * lateral[0] + m_inverseMass[i][1] * lateral[1] +
               m_inverseMass[i][2] * lateral[2];
    };
    return {surge_N / (k.mass_kg - k.Xudot), row(0), row(1), row(2)};
}

}  // namespace sagara::core
