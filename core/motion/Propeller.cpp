#include "core/motion/Propeller.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/SmoothStep.h"

namespace sagara::core {
namespace {

constexpr double kTurning = 0.7 * kPi;  // of the blade at 0.7 R, over n D
constexpr double kFadeBefore_rad = 40.0 * kDegree_rad, kFadeBehind_rad = 30.0 * kDegree_rad;

double thrustCoefficient(const PropulsionUnit& unit, double J) {
    const double held = std::clamp(J, -0.6, 1.4);
    return unit.thrustCoefficients[0] +
           held * (unit.thrustCoefficients[1] + held * unit.thrustCoefficients[2]);
}

}  // namespace

Propeller::Propeller(const PropulsionUnit& unit) : m_unit(unit) {
    if (m_unit.openWater) m_end_rad = std::atan2(m_unit.openWater->highestJ(), kTurning);
}

PropellerForce Propeller::thrustAlone(double shaft_rps, double inflow_mps, double density_kgpm3) const {
    constexpr double kStanding_rps = 1e-3;
    if (std::abs(shaft_rps) < kStanding_rps) return {};
    const double scale_N = density_kgpm3 * shaft_rps * shaft_rps * std::pow(m_unit.diameter_m, 4);
    const double J = inflow_mps / (std::abs(shaft_rps) * m_unit.diameter_m);
    if (shaft_rps > 0.0) return {scale_N * thrustCoefficient(m_unit, J), 0.0};
    return {-m_unit.asternThrustRatio * scale_N * thrustCoefficient(m_unit, std::max(0.0, -J)), 0.0};
}

StarCoefficients Propeller::own(double beta_rad) const {
    const double J = kTurning * std::tan(beta_rad);
    const double scale = 8.0 / kPi / (J * J + kTurning * kTurning);
    const OpenWaterPoint k = m_unit.openWater->at(J);
    return {scale * k.thrust, scale * k.torque};
}

StarCoefficients Propeller::ownLessSeries(double beta_rad) const {
    if (beta_rad <= -kFadeBefore_rad || beta_rad >= m_end_rad + kFadeBehind_rad) return {};
    const double edge_rad = std::clamp(beta_rad, 0.0, m_end_rad);
    const double beyond_rad = beta_rad - edge_rad;
    const double left =
        1.0 - smoothStep(0.0, beyond_rad < 0.0 ? kFadeBefore_rad : kFadeBehind_rad, std::abs(beyond_rad));
    const BScrew& screw = m_unit.openWater->screw;
    const StarCoefficients mine = own(edge_rad),
                           series = fourQuadrants(edge_rad, screw.pitchRatio, screw.areaRatio);
    return {left * (mine.thrust - series.thrust), left * (mine.torque - series.torque)};
}

StarCoefficients Propeller::star(double beta_rad, double pitch) const {
    if (pitch == 1.0 && beta_rad >= 0.0 && beta_rad <= m_end_rad) return own(beta_rad);
    const BScrew& screw = m_unit.openWater->screw;
    StarCoefficients c = fourQuadrants(beta_rad, pitch * screw.pitchRatio, screw.areaRatio);
    constexpr double kLeast = 0.05;  // of the design pitch: with none the propeller has no own side
    if (pitch <= kLeast) return c;
    // A blade of less pitch comes to the end of its thrust at so much less advance.
    const StarCoefficients more = ownLessSeries(beta_rad / pitch);
    const double share = std::min(1.0, pitch);
    return {c.thrust + share * more.thrust, c.torque + share * more.torque};
}

PropellerForce Propeller::force(double shaft_rps, double pitch, double inflow_mps,
                                double density_kgpm3) const {
    if (!m_unit.openWater) return thrustAlone(shaft_rps, inflow_mps, density_kgpm3);
    const double D_m = m_unit.diameter_m, turning_mps = kTurning * shaft_rps * D_m;
    const double speed2 = inflow_mps * inflow_mps + turning_mps * turning_mps;
    if (speed2 == 0.0) return {};
    const StarCoefficients c = star(std::atan2(inflow_mps, turning_mps), pitch);
    const double scale_N = 0.125 * kPi * density_kgpm3 * speed2 * D_m * D_m;
    return {scale_N * c.thrust, scale_N * D_m * c.torque};
}

std::vector<Propeller> propellersOf(const Propulsion& propulsion) {
    return {propulsion.units.begin(), propulsion.units.end()};
}

double inflowOf_mps(const PropulsionUnit& unit, const ShipMotion& m, double azimuth_rad) {
    const double ahead_mps = m.surge_mps - m.yawRate_radps * unit.position.y_m,
                 across_mps = m.sway_mps + m.yawRate_radps * unit.position.x_m;
    const double wake = ahead_mps > 0.0 ? unit.wakeFraction : 0.0;
    return (1.0 - wake) * ahead_mps * std::cos(azimuth_rad) + across_mps * std::sin(azimuth_rad);
}

double addedRaceSquared(const PropulsionUnit& unit, double thrust_N, double density_kgpm3) {
    const double disc_m2 = kPi / 4.0 * unit.diameter_m * unit.diameter_m;
    return std::max(0.0, 2.0 * thrust_N / (density_kgpm3 * disc_m2));
}

}  // namespace sagara::core
