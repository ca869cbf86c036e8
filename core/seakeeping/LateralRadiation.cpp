#include "core/seakeeping/LateralRadiation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"
#include "core/sea/Dispersion.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;

/// Wave number times length: to here all sections together, from there each alone.
constexpr double kTogether = 5.0, kAlone = 20.0;
constexpr std::array<std::size_t, 3> kLateral{1, 3, 5};

double lengthOf(const StripHull& hull) { return hull.x_m.back() - hull.x_m.front(); }

/// Amplitude of the waves each section sends out in sway, roll and yaw of frame B; the square is its damping.
std::array<std::vector<double>, 3> amplitudes(const StripHull& hull, const HullFlow& flow) {
    std::array<std::vector<double>, 3> list;
    for (std::size_t i = 0; i < hull.strips.size(); ++i) {
        const SectionCoefficients b = radiationOf(hull.strips[i].panels, flow.strips[i]).dampingOverOmega;
        const double sway = std::sqrt(std::max(0.0, b.sway_m2));
        list[0].push_back(sway);
        list[1].push_back(sway > 0.0 ? -b.swayRoll_m3 / sway : 0.0);
        list[2].push_back(sway * hull.x_m[i]);
    }
    return list;
}

/// Together, for a swing of unit velocity.
Matrix6 sentOut(const StripHull& hull, const HullFlow& flow) {
    const auto amplitude = amplitudes(hull, flow);
    const double k = deepWaveNumber_radpm(flow.omega_radps, kGravity_mps2);
    constexpr int kDirections = 48;  // of a quarter; the other three are alike
    Matrix6 sum;
    std::vector<double> values(hull.x_m.size());
    for (int d = 0; d < kDirections; ++d) {
        const double beta = 0.5 * kPi * (d + 0.5) / kDirections;
        const double along = k * std::cos(beta), across = std::sin(beta);
        std::array<Complex, 3> far;
        for (std::size_t m = 0; m < 3; ++m) {
            const auto over = [&](auto wave) {
                for (std::size_t i = 0; i < values.size(); ++i)
                    values[i] = amplitude[m][i] * wave(along * hull.x_m[i]);
                return alongStations(hull.x_m, values, 0);
            };
            far[m] = across * Complex(over([](double x) { return std::cos(x); }),
                                      over([](double x) { return std::sin(x); }));
        }
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t n = 0; n < 3; ++n)
                sum(kLateral[m], kLateral[n]) += (far[m] * std::conj(far[n])).real();
    }
    const double scale = hull.waterDensity_kgpm3 * flow.omega_radps * k / (2.0 * kDirections);
    for (const std::size_t i : kLateral)
        for (const std::size_t j : kLateral) sum(i, j) *= scale;
    return sum;
}

/// Integral of 1 / (s^2 - w^2) and of s / (s^2 - w^2), principal value.
double overEven(double s, double w) { return std::log(std::abs((s - w) / (s + w))) / (2.0 * w); }
double overOdd(double s, double w) { return 0.5 * std::log(std::abs(s * s - w * w)); }

}  // namespace

LateralRadiation::LateralRadiation(const StripHull& hull, const std::vector<HullFlow>& flows) {
    for (const HullFlow& flow : flows) learn(hull, flow);
    finish(hull);
}

LateralRadiation::LateralRadiation(const StripHull& hull) {
    const double unit_radps = std::sqrt(kGravity_mps2 / lengthOf(hull));
    constexpr double kFirst = 0.3, kRatio = 1.14;
    for (double omega = kFirst; omega * omega < kAlone; omega *= kRatio)
        learn(hull, flowAbout(hull, omega * unit_radps));
    finish(hull);
}

void LateralRadiation::finish(const StripHull& hull) {
    m_omega_radps.push_back(std::sqrt(kAlone * kGravity_mps2 / lengthOf(hull)));
    m_damping.emplace_back();
    const Matrix6 slow = addedMassAt(1e-3 * m_omega_radps.front());
    for (const std::size_t i : kLateral)
        for (const std::size_t j : kLateral) m_atInfinity(i, j) = -slow(i, j);
}

void LateralRadiation::learn(const StripHull& hull, const HullFlow& flow) {
    const double kL = deepWaveNumber_radpm(flow.omega_radps, kGravity_mps2) * lengthOf(hull);
    if (kL >= kAlone) return;
    const double way = std::min(1.0, (kAlone - kL) / (kAlone - kTogether));
    const double share = way * way * (3.0 - 2.0 * way);
    const Matrix6 strips = radiationOf(hull, flow).damping;
    Matrix6 change = sentOut(hull, flow);
    for (const std::size_t i : kLateral)
        for (const std::size_t j : kLateral) change(i, j) = share * (change(i, j) - strips(i, j));
    m_omega_radps.push_back(flow.omega_radps);
    m_damping.push_back(change);
}

Radiation LateralRadiation::of(const StripHull& hull, const HullFlow& flow) const {
    Radiation r = radiationOf(hull, flow);
    const Matrix6 damping = dampingAt(flow.omega_radps), added = addedMassAt(flow.omega_radps);
    for (const std::size_t i : kLateral) {
        for (const std::size_t j : kLateral) {
            r.damping(i, j) += damping(i, j);
            r.addedMass(i, j) += added(i, j);
        }
    }
    return r;
}

Matrix6 LateralRadiation::dampingAt(double omega_radps) const {
    const auto above = std::lower_bound(m_omega_radps.begin(), m_omega_radps.end(), omega_radps);
    if (above == m_omega_radps.end()) return {};
    const auto n = static_cast<std::size_t>(above - m_omega_radps.begin());
    const double from = n == 0 ? 0.0 : m_omega_radps[n - 1];
    const double share = (omega_radps - from) / (*above - from);
    const Matrix6 low = n == 0 ? Matrix6{} : m_damping[n - 1];
    Matrix6 b;
    for (const std::size_t i : kLateral) {
        for (const std::size_t j : kLateral) {
            const double lower = low(i, j), upper = m_damping[n](i, j);
            b(i, j) =
                lower * upper > 0.0
                    ? lower * std::pow(upper / lower, std::log(omega_radps / from) / std::log(*above / from))
                    : lower + share * (upper - lower);
        }
    }
    return b;
}

Matrix6 LateralRadiation::addedMassAt(double omega_radps) const {
    Matrix6 a = m_atInfinity;
    double from = 0.0;
    Matrix6 low;
    constexpr double kBeside = 1e-7;  // the logarithms of two neighbours cancel, but not on the point itself
    const double w = omega_radps * (1.0 + kBeside);
    for (std::size_t n = 0; n < m_omega_radps.size(); ++n) {
        const double to = m_omega_radps[n];
        const double even = overEven(to, w) - overEven(from, w), odd = overOdd(to, w) - overOdd(from, w);
        for (const std::size_t i : kLateral) {
            for (const std::size_t j : kLateral) {
                const double slope = (m_damping[n](i, j) - low(i, j)) / (to - from);
                a(i, j) += 2.0 / kPi * ((low(i, j) - slope * from) * even + slope * odd);
            }
        }
        from = to;
        low = m_damping[n];
    }
    return a;
}

}  // namespace sagara::core
