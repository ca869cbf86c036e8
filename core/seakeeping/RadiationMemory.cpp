#include "core/seakeeping/RadiationMemory.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;

std::size_t firstOf(std::size_t motion) { return (motion - 1) * 2 * kMemoryFilters; }

/// G of the whole hull, or all of the aftmost section.
MemoryCurve curveOf(const SeakeepingTables& t, std::size_t i, std::size_t j, bool end) {
    MemoryCurve curve;
    curve.direct = end;
    for (std::size_t n = 0; n < t.omega_radps.size(); ++n) {
        const Radiation& r = t.radiation[n];
        const double a = end ? r.endAddedMass(i, j) : r.addedMass(i, j) - t.addedMassInfinite(i, j);
        const double b = end ? r.endDamping(i, j) : r.damping(i, j);
        curve.value.push_back({a, -b / t.omega_radps[n]});
    }
    return curve;
}

double greatest(const MemoryCurve& curve) {
    double most = 0.0;
    for (const Complex& v : curve.value) most = std::max(most, std::abs(v));
    return most;
}

Six product(const std::array<MemoryState, 6>& rows, const MemoryState& state) {
    Six sum{};
    for (std::size_t i = 1; i < 6; ++i)
        for (std::size_t k = 0; k < kMemoryValues; ++k) sum[i] += rows[i][k] * state[k];
    return sum;
}

}  // namespace

RadiationMemory::RadiationMemory(const SeakeepingTables& tables) : m_infinite(tables.addedMassInfinite) {
    fit(tables, m_lateral, {1, 3, 5});
    fit(tables, m_vertical, {2, 4});
    for (const Radiation& r : tables.radiation)
        for (std::size_t i = 1; i < 6; ++i) m_mostDamping[i] = std::max(m_mostDamping[i], r.damping(i, i));
    m_slowEnd = m_endDirect;
    for (std::size_t i = 1; i < 6; ++i) {
        for (std::size_t j = 1; j < 6; ++j) {
            for (std::size_t k = 0; k < kMemoryFilters; ++k) {
                const std::size_t at = firstOf(j) + 2 * k;
                m_slow(i, j) += m_whole[i][at] / bankOf(j)[k].stiffness_perS2;
                m_slowEnd(i, j) += m_end[i][at] / bankOf(j)[k].stiffness_perS2;
            }
        }
    }
}

void RadiationMemory::fit(const SeakeepingTables& tables, FilterBank& bank,
                          const std::vector<std::size_t>& motions) {
    const double unit_radps = std::sqrt(kGravity_mps2 / tables.lengthBp_m);
    std::vector<double> omega;
    for (const double w : tables.omega_radps) omega.push_back(w / unit_radps);
    const auto matters = [&](std::size_t i, std::size_t j, bool end) {
        const double own =
            std::sqrt(greatest(curveOf(tables, i, i, end)) * greatest(curveOf(tables, j, j, end)));
        return own > 0.0 && greatest(curveOf(tables, i, j, end)) > 1e-6 * own;
    };
    std::vector<MemoryCurve> curves;
    for (const std::size_t i : motions)
        for (const std::size_t j : motions)
            for (const bool end : {false, true})
                if (i <= j && matters(i, j, end)) curves.push_back(curveOf(tables, i, j, end));
    const FilterBank scaled = commonFilters(omega, curves);
    for (std::size_t k = 0; k < kMemoryFilters; ++k)
        bank[k] = {scaled[k].stiffness_perS2 * unit_radps * unit_radps, scaled[k].damping_perS * unit_radps};
    for (const std::size_t i : motions) {
        for (const std::size_t j : motions) {
            for (const bool end : {false, true}) {
                if (!matters(i, j, end)) continue;
                const auto share = onFilters(scaled, omega, curveOf(tables, i, j, end));
                MemoryState& row = end ? m_end[i] : m_whole[i];
                for (std::size_t k = 0; k < kMemoryFilters; ++k) {
                    row[firstOf(j) + 2 * k] = share[2 * k] * unit_radps * unit_radps;
                    row[firstOf(j) + 2 * k + 1] = share[2 * k + 1] * unit_radps;
                }
                if (end) m_endDirect(i, j) = share.back();
            }
        }
    }
}

MemoryState RadiationMemory::rate(const MemoryState& state, const Six& velocity) const {
    MemoryState rate;
    for (std::size_t j = 1; j < 6; ++j) {
        const FilterBank& bank = bankOf(j);
        for (std::size_t k = 0; k < kMemoryFilters; ++k) {
            const std::size_t at = firstOf(j) + 2 * k;
            rate[at] = state[at + 1];
            rate[at + 1] =
                velocity[j] - bank[k].stiffness_perS2 * state[at] - bank[k].damping_perS * state[at + 1];
        }
    }
    return rate;
}

Six RadiationMemory::momentum(const MemoryState& state) const { return product(m_whole, state); }

Six RadiationMemory::endMomentum(const MemoryState& state, const Six& velocity) const {
    Six sum = product(m_end, state);
    for (std::size_t i = 1; i < 6; ++i)
        for (std::size_t j = 1; j < 6; ++j) sum[i] += m_endDirect(i, j) * velocity[j];
    return sum;
}

Radiation RadiationMemory::radiationAt(double omega_radps) const {
    const Complex s(0.0, omega_radps);
    Radiation r;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            Complex whole = m_infinite(i, j), end = m_endDirect(i, j);
            for (std::size_t k = 0; j > 0 && k < kMemoryFilters; ++k) {
                const MemoryFilter& f = bankOf(j)[k];
                const Complex position = 1.0 / (s * s + f.damping_perS * s + f.stiffness_perS2);
                const std::size_t at = firstOf(j) + 2 * k;
                whole += position * (m_whole[i][at] + s * m_whole[i][at + 1]);
                end += position * (m_end[i][at] + s * m_end[i][at + 1]);
            }
            r.addedMass(i, j) = whole.real();
            r.damping(i, j) = -omega_radps * whole.imag();
            r.endAddedMass(i, j) = end.real();
            r.endDamping(i, j) = -omega_radps * end.imag();
        }
    }
    return r;
}

double RadiationMemory::leastDamping(double omega_radps) const {
    const Matrix6 B = radiationAt(omega_radps).damping;
    Eigen::Matrix3d lateral;
    Eigen::Matrix2d vertical;
    constexpr std::size_t kLateral[] = {1, 3, 5};
    const auto over = [&](std::size_t i, std::size_t j) {
        const double unit = std::sqrt(m_mostDamping[i] * m_mostDamping[j]);
        return unit > 0.0 ? 0.5 * (B(i, j) + B(j, i)) / unit : 0.0;
    };
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            lateral(static_cast<int>(i), static_cast<int>(j)) = over(kLateral[i], kLateral[j]);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            vertical(static_cast<int>(i), static_cast<int>(j)) = over(2 + 2 * i, 2 + 2 * j);
    return std::min(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(lateral).eigenvalues()(0),
                    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(vertical).eigenvalues()(0));
}

}  // namespace sagara::core
