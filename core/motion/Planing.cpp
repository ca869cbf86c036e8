#include "core/motion/Planing.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/SmoothStep.h"

namespace sagara::core {
namespace {

constexpr double kStep_mps = 0.5, kFastest_mps = 50.0;
constexpr double kFloats = 0.6, kPlanes = 1.6;  // C_V
constexpr double kMost_deg = 15.0;              // of trim: the formulas hold to there

/// Where a rising function reaches a value.
template <typename F>
double solve(F&& f, double value, double low, double high) {
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

PlaningLift planingLift(double speedCoefficient, double trim_deg, double wettedOverBeam) {
    const double tau = std::pow(trim_deg, 1.1), lambda = wettedOverBeam;
    return {tau * 0.0120 * std::sqrt(lambda),
            tau * 0.0055 * std::pow(lambda, 2.5) / (speedCoefficient * speedCoefficient)};
}

double wedgeLift(double flatLift, double deadrise_rad) {
    return flatLift - 0.0065 * deadrise_rad / kDegree_rad * std::pow(flatLift, 0.60);
}

double flatLift(double wedge, double deadrise_rad) {
    // What the deadrise takes is less than the whole, so the lift of the plate is no more than this.
    const double most = 2.0 * wedge + 0.2;
    return solve([&](double flat) { return wedgeLift(flat, deadrise_rad); }, wedge, 1e-6, most);
}

double pressureCentre(double speedCoefficient, double wettedOverBeam) {
    const double lambda = wettedOverBeam, over = speedCoefficient / lambda;
    return lambda * (0.75 - 1.0 / (5.21 * over * over + 2.39));
}

double wettedKeel(double trim_rad, double wettedOverBeam, double deadrise_rad) {
    return wettedOverBeam + std::tan(deadrise_rad) / (kTwoPi * std::tan(trim_rad));
}

Planing::Planing(const PlaningHull& bottom, const Hull& hull)
    : m_bottom(bottom),
      m_weight_N(hull.mass_kg() * kGravity_mps2),
      m_density_kgpm3(hull.waterDensity_kgpm3),
      m_length_m(hull.lengthBp_m),
      m_draught_m(hull.draught_m) {
    for (double U = 0.0; U <= kFastest_mps; U += kStep_mps) m_attitudes.push_back(running(U));
}

RunningAttitude Planing::running(double surge_mps) const {
    const double b = m_bottom.chineBeam_m, beta = m_bottom.deadrise_rad;
    const double speed = surge_mps / std::sqrt(kGravity_mps2 * b);
    if (speed <= kFloats) return {};
    const double lambda = solve([&](double wetted) { return pressureCentre(speed, wetted); },
                                m_bottom.gravityFromTransom_m / b, 0.1, 12.0);
    const double lift = m_weight_N / (0.5 * m_density_kgpm3 * surge_mps * surge_mps * b * b);
    const PlaningLift perDegree = planingLift(speed, 1.0, lambda);
    const double trim_deg = std::min(kMost_deg, std::pow(flatLift(lift, beta) / perDegree.flat(), 1.0 / 1.1));
    const double trim_rad = trim_deg * kDegree_rad;
    const double forward_m = m_bottom.gravityFromTransom_m - 0.5 * m_length_m;  // of G, from midship
    const double keelDepth_m =
        (b * wettedKeel(trim_rad, lambda, beta) - m_bottom.gravityFromTransom_m) * std::sin(trim_rad);
    const double share = smoothStep(kFloats, kPlanes, speed);
    return {share * (keelDepth_m - m_draught_m + forward_m * std::sin(trim_rad)), share * trim_rad,
            share * perDegree.dynamic / perDegree.flat()};
}

RunningAttitude Planing::at(double surge_mps) const {
    const double last = static_cast<double>(m_attitudes.size() - 1);
    const double place = std::clamp(surge_mps / kStep_mps, 0.0, last);
    const auto low = std::min(static_cast<std::size_t>(place), m_attitudes.size() - 2);
    const double share = place - static_cast<double>(low);
    const RunningAttitude &a = m_attitudes[low], &b = m_attitudes[low + 1];
    const auto mix = [&](double x, double y) { return x + share * (y - x); };
    return {mix(a.down_m, b.down_m), mix(a.pitch_rad, b.pitch_rad), mix(a.planing, b.planing)};
}

double Planing::sideForceDepth_m(double surge_mps, double floating_m) const {
    const double above_m = m_bottom.chineBeam_m / (2.0 * std::sin(2.0 * m_bottom.deadrise_rad));
    return floating_m + at(surge_mps).planing * (m_draught_m - above_m - floating_m);
}

}  // namespace sagara::core
