#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "core/seakeeping/SeakeepingTables.h"

namespace sagara::core {

/// Of the six motions, in the order and frame of `SeakeepingTables`.
using Six = std::array<double, 6>;

/// What the water around a ship remembers of her motions: for each velocity but surge six filters of second
/// order, two values each.
inline constexpr std::size_t kMemoryFilters = 6;
inline constexpr std::size_t kMemoryValues = 5 * 2 * kMemoryFilters;
using MemoryState = std::array<double, kMemoryValues>;

/// x'' + damping x' + stiffness x = velocity
struct MemoryFilter {
    double stiffness_perS2 = 0.0;
    double damping_perS = 0.0;
};
using FilterBank = std::array<MemoryFilter, kMemoryFilters>;

/// Memory of radiated waves as a state space in place of Cummins' convolution (1962, Schiffstechnik 9).
///
/// With the complex added mass A(w) - i B(w) / w, the momentum of the water is (A_inf + G(iw)) v. G is what
/// is kept here: rational, strictly proper, with poles common to all lateral and to all vertical motions,
/// found by vector fitting (Gustavsen and Semlyen 1999, IEEE Trans. Power Delivery 14, 1052-1061) of the
/// tables; poles that come out unstable are mirrored (Perez and Fossen 2009, Modeling Identification and
/// Control 30, 1-15, on such fits for ships). G(0) = A(0) - A_inf, and nothing is damped at w = 0.
///
/// `velocity` is always that of frame B through the water, so that at speed U pitch counts in heave and yaw
/// in sway, as in `radiationAt`; the force at speed is then -dp/dt + U (L^T p - end momentum).
class RadiationMemory {
public:
    explicit RadiationMemory(const SeakeepingTables& tables);

    MemoryState rate(const MemoryState& state, const Six& velocity) const;
    /// G v in N s and N m s; of a rate of the state: its rate.
    Six momentum(const MemoryState& state) const;
    /// Of the aftmost section, per unit length: all of it, with what follows at once.
    Six endMomentum(const MemoryState& state, const Six& velocity) const;
    /// G(0): what the water adds to A_inf for slow motions.
    const Matrix6& slowAddedMass() const { return m_slow; }
    /// The same of the momentum of the aftmost section, with what follows at once.
    const Matrix6& slowEndMass() const { return m_slowEnd; }
    /// As the tables have it, from the filters.
    Radiation radiationAt(double omega_radps) const;
    /// Smallest eigenvalue of the damping, each motion in units of its greatest damping in the tables,
    /// lateral and vertical, least of both: a passive memory has none below 0.
    double leastDamping(double omega_radps) const;

private:
    const FilterBank& bankOf(std::size_t motion) const {
        return motion == 2 || motion == 4 ? m_vertical : m_lateral;
    }
    void fit(const SeakeepingTables& tables, FilterBank& bank, const std::vector<std::size_t>& motions);

    Matrix6 m_infinite;
    FilterBank m_lateral;
    FilterBank m_vertical;
    std::array<MemoryState, 6> m_whole{};  ///< rows: from the state to the momentum
    std::array<MemoryState, 6> m_end{};
    Matrix6 m_endDirect;
    Matrix6 m_slow;
    Matrix6 m_slowEnd;
    Six m_mostDamping{};  ///< of each motion in the tables
};

/// One curve of complex values over the frequencies. `direct`: with a constant that stays at infinity.
struct MemoryCurve {
    std::vector<std::complex<double>> value;
    bool direct = false;
};
/// The poles that all curves have in common, by vector fitting. Frequencies in units of order one.
FilterBank commonFilters(const std::vector<double>& omega, const std::vector<MemoryCurve>& curves);
/// Least squares over the frequencies: x and x' of each filter, then the constant.
std::array<double, 2 * kMemoryFilters + 1> onFilters(const FilterBank& bank, const std::vector<double>& omega,
                                                     const MemoryCurve& curve);

}  // namespace sagara::core
