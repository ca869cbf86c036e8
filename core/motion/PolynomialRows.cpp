#include "core/motion/PolynomialRows.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

using Factor = PolynomialTerm::Factor;
constexpr std::size_t kQuantities = static_cast<std::size_t>(Factor::Count);

/// Newtons per (m/s)^2 for one unit of force in the set.
double forceOf(const PolynomialScale& scale, const Hull& hull) {
    const double L = scale.length_m;
    switch (scale.by) {
        case PolynomialScale::By::Si:
            return 1.0;
        case PolynomialScale::By::Bis:
            return hull.mass_kg() / L;
        default:
            return 0.5 * hull.waterDensity_kgpm3 * L * L;
    }
}

double meanShaft_rps(const Actuators& actuators, std::size_t count) {
    double sum_rps = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum_rps += actuators.shaft_rps[i];
    return count > 0 ? sum_rps / static_cast<double>(count) : 0.0;
}

}  // namespace

PolynomialRows::PolynomialRows(const PolynomialModel& model, const Vessel& vessel)
    : m_scale(model.scale),
      m_force_kgpm(forceOf(model.scale, vessel.hull)),
      m_bisSpeed_mps(std::sqrt(kGravity_mps2 * model.scale.length_m)),
      m_draught_m(model.draught_m),
      m_leastDepthRatio(model.leastDepthRatio),
      m_inflow_m(model.inflow_m),
      m_inflow_m2(model.inflow_m2),
      m_shafts(vessel.propulsion.units.size()) {
    for (const PolynomialTerm& term : model.terms) {
        const auto part = term.has(Factor::Rudder)  ? &HullForces::rudder
                          : term.has(Factor::Shaft) ? &HullForces::propeller
                                                    : &HullForces::hull;
        m_rows.push_back({term, part});
    }
}

double PolynomialRows::depthParameter(double depth_m) const {
    if (m_draught_m <= 0.0) return 0.0;
    return 1.0 / (std::max(depth_m / m_draught_m, m_leastDepthRatio) - 1.0);
}

double PolynomialRows::unitSpeed_mps(const ShipMotion& m) const {
    constexpr double kLeast_mps = 1e-3;  // a set made so does not hold at rest
    switch (m_scale.by) {
        case PolynomialScale::By::Si:
            return 1.0;
        case PolynomialScale::By::Bis:
            return m_bisSpeed_mps;
        case PolynomialScale::By::PrimeReference:
            return m_scale.referenceSpeed_mps;
        case PolynomialScale::By::Prime:
            break;
    }
    return std::max(kLeast_mps, std::hypot(m.surge_mps, m.sway_mps));
}

HullForces PolynomialRows::at(const ShipMotion& m, const Actuators& actuators, double depth_m,
                              double crossFlow) const {
    const double U = unitSpeed_mps(m), L = m_scale.length_m, z = depthParameter(depth_m);
    const double n_rps = meanShaft_rps(actuators, m_shafts);
    const double u = (m_scale.perturbation ? m.surge_mps - m_scale.referenceSpeed_mps : m.surge_mps) / U;
    const double inflow2 = m_inflow_m * m.surge_mps * n_rps + m_inflow_m2 * n_rps * n_rps;
    std::array<double, 2 * kQuantities> value{1.0,
                                              u,
                                              m.sway_mps / U,
                                              m.yawRate_radps * L / U,
                                              m.rollRate_radps * L / U,
                                              m.roll_rad,
                                              m_scale.rudderSign * actuators.rudder_rad,
                                              std::sqrt(std::max(0.0, inflow2)) / U,
                                              n_rps * L / U,
                                              std::atan2(m.sway_mps, std::abs(m.surge_mps)),
                                              z};
    for (std::size_t i = 0; i < kQuantities; ++i) value[kQuantities + i] = std::abs(value[i]);

    const double astern = m.surge_mps < 0.0 ? -1.0 : 1.0;
    const double force_N = m_force_kgpm * U * U, moment_Nm = force_N * L;
    HullForces sum;
    for (const Row& row : m_rows) {
        const PolynomialTerm& term = row.term;
        if (z < term.fromDepth) continue;
        double product = (term.crossFlow ? crossFlow : 1.0) * (term.turnsAstern ? astern : 1.0);
        for (const Factor factor : term.factors) product *= value[static_cast<std::size_t>(factor)];
        Load& part = sum.*row.part;
        part.surge_N += force_N * term.surge * product;
        part.sway_N += force_N * term.sway * product;
        part.roll_Nm += moment_Nm * term.roll * product;
        part.yaw_Nm += moment_Nm * term.yaw * product;
    }
    return sum;
}

}  // namespace sagara::core
