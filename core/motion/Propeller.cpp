#include "core/motion/Propeller.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

double thrustCoefficient(const PropulsionUnit& unit, double J) {
    const double held = std::clamp(J, -0.6, 1.4);
    return unit.thrustCoefficients[0] +
           held * (unit.thrustCoefficients[1] + held * unit.thrustCoefficients[2]);
}

}  // namespace

PropellerForce Propeller::force(double shaft_rps, double, double inflow_mps, double density_kgpm3) const {
    constexpr double kStanding_rps = 1e-3;
    if (std::abs(shaft_rps) < kStanding_rps) return {};
    const double scale_N = density_kgpm3 * shaft_rps * shaft_rps * std::pow(m_unit.diameter_m, 4);
    const double J = inflow_mps / (std::abs(shaft_rps) * m_unit.diameter_m);
    if (shaft_rps > 0.0) return {scale_N * thrustCoefficient(m_unit, J), 0.0};
    return {-m_unit.asternThrustRatio * scale_N * thrustCoefficient(m_unit, std::max(0.0, -J)), 0.0};
}

std::vector<Propeller> propellersOf(const Propulsion& propulsion) {
    return {propulsion.units.begin(), propulsion.units.end()};
}

double addedRaceSquared(const PropulsionUnit& unit, double thrust_N, double density_kgpm3) {
    const double disc_m2 = kPi / 4.0 * unit.diameter_m * unit.diameter_m;
    return std::max(0.0, 2.0 * thrust_N / (density_kgpm3 * disc_m2));
}

}  // namespace sagara::core
