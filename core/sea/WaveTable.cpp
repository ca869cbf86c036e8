#include "core/sea/WaveTable.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Random.h"
#include "core/sea/Dispersion.h"

namespace sagara::core {
namespace {

constexpr double kRingRatio = 1.17;  // 8 % in frequency
constexpr int kSamplesPerRing = 8;   // of the spectrum, so that a narrow peak is not missed

}  // namespace

double WaveBand::step_radpm() const { return kTwoPi / tile_m; }

WaveTable::WaveTable(std::uint64_t seed, double depth_m) : m_depth_m(depth_m) {
    for (std::uint8_t band = 0; band < kWaveBands.size(); ++band) {
        const WaveBand& b = kWaveBands[band];
        const int rings =
            static_cast<int>(std::ceil(std::log(b.high_radpm / b.low_radpm) / std::log(kRingRatio)));
        const double ratio = std::pow(b.high_radpm / b.low_radpm, 1.0 / rings);
        for (int i = 0; i < rings; ++i) {
            m_rings.push_back({b.low_radpm * std::pow(ratio, i), b.low_radpm * std::pow(ratio, i + 1), band});
        }
        if (band < 2) m_longRings = m_rings.size();
    }
    Random random(seed ^ 0x7761766573000000ULL);
    for (std::size_t ring = 0; ring < m_longRings; ++ring) {
        for (std::size_t direction = 0; direction < kDirections; ++direction)
            addLongCell(ring, direction, random);
    }
    const WaveBand& fine = kWaveBands[2];
    const int half = kLatticeSize / 2;
    for (int i = -half; i < half; ++i) {
        for (int j = -half; j < half; ++j) {
            const double kNorth = i * fine.step_radpm(), kEast = j * fine.step_radpm();
            const double k = std::hypot(kNorth, kEast);
            if (k < fine.low_radpm || k >= fine.high_radpm) continue;
            std::size_t ring = m_longRings;
            while (k >= m_rings[ring].high_radpm && ring + 1 < m_rings.size()) ++ring;
            m_shortRing.push_back(static_cast<std::uint16_t>(ring));
            m_short.push_back({kNorth, kEast, angularFrequency_radps(k, depth_m, kGravity_mps2),
                               kTwoPi * random.uniform(), std::uint8_t{2}});
        }
    }
}

WaveTable WaveTable::regular(double omega_radps, double wavesTo_rad, double depth_m) {
    WaveTable table(depth_m);
    const double k = waveNumber_radpm(omega_radps, depth_m, kGravity_mps2);
    table.m_long.push_back(
        {k * std::cos(wavesTo_rad), k * std::sin(wavesTo_rad), omega_radps, 0.0, std::uint8_t{0}});
    return table;
}

void WaveTable::addLongCell(std::size_t ring, std::size_t direction, Random& random) {
    const Ring& r = m_rings[ring];
    const double step_radpm = kWaveBands[r.band].step_radpm();
    // Anywhere in the middle half of the cell, so that the rings and rays do not show.
    const double k = r.low_radpm + (0.25 + 0.5 * random.uniform()) * (r.high_radpm - r.low_radpm);
    const double theta_rad =
        (static_cast<double>(direction) + 0.5 * (random.uniform() - 0.5)) * kTwoPi / kDirections;
    const double phase_rad = kTwoPi * random.uniform();
    const double kNorth = std::round(k * std::cos(theta_rad) / step_radpm) * step_radpm;
    const double kEast = std::round(k * std::sin(theta_rad) / step_radpm) * step_radpm;
    // Small cells share a lattice point with a neighbour: one component then carries the energy of both.
    std::size_t index = 0;
    while (index < m_long.size() && !(m_long[index].band == r.band && m_long[index].kNorth_radpm == kNorth &&
                                      m_long[index].kEast_radpm == kEast)) {
        ++index;
    }
    if (index == m_long.size()) {
        const double omega_radps =
            angularFrequency_radps(std::hypot(kNorth, kEast), m_depth_m, kGravity_mps2);
        m_long.push_back({kNorth, kEast, omega_radps, phase_rad, r.band});
    }
    m_cellComponent.push_back(static_cast<std::uint16_t>(index));
}

std::vector<double> WaveTable::ringShares(const SeaSystem& system) const {
    SeaSystem unit = system;
    unit.significantHeight_m = 1.0;
    std::vector<double> shares;
    double total = 0.0;
    for (const Ring& ring : m_rings) {
        const double from = angularFrequency_radps(ring.low_radpm, m_depth_m, kGravity_mps2);
        const double step =
            (angularFrequency_radps(ring.high_radpm, m_depth_m, kGravity_mps2) - from) / kSamplesPerRing;
        double energy = 0.0;
        for (int i = 0; i < kSamplesPerRing; ++i) {
            energy += step * spectrum_m2s(unit, from + (i + 0.5) * step);
        }
        shares.push_back(energy);
        total += energy;
    }
    if (total == 0.0) return shares;  // a band of a measured sea that is too long for any lattice
    for (double& share : shares) share /= total;
    return shares;
}

void WaveTable::addEnergy(const SeaSystem& system, std::vector<double>& energy_m2) const {
    assert(energy_m2.size() == m_long.size());
    std::array<double, kDirections> direction{};
    double sum = 0.0;
    for (std::size_t j = 0; j < kDirections; ++j) {
        direction[j] =
            spreading_perRad(system, static_cast<double>(j) * kTwoPi / kDirections - system.wavesTo_rad);
        sum += direction[j];
    }
    const double total_m2 = system.significantHeight_m * system.significantHeight_m / 16.0;
    const std::vector<double> ring = ringShares(system);
    for (std::size_t cell = 0; cell < m_cellComponent.size(); ++cell) {
        energy_m2[m_cellComponent[cell]] +=
            total_m2 * ring[cell / kDirections] * direction[cell % kDirections] / sum;
    }
}

void WaveTable::addShortEnergy(const SeaSystem& system, std::vector<double>& energy_m2) const {
    assert(energy_m2.size() == m_short.size());
    const std::vector<double> ring = ringShares(system);
    if (std::all_of(ring.begin() + static_cast<std::ptrdiff_t>(m_longRings), ring.end(),
                    [](double share) { return share == 0.0; }))
        return;
    std::vector<double> weight(m_short.size()), ringWeight(m_rings.size(), 0.0);
    for (std::size_t i = 0; i < m_short.size(); ++i) {
        const double theta_rad = std::atan2(m_short[i].kEast_radpm, m_short[i].kNorth_radpm);
        weight[i] = spreading_perRad(system, theta_rad - system.wavesTo_rad);
        ringWeight[m_shortRing[i]] += weight[i];
    }
    const double total_m2 = system.significantHeight_m * system.significantHeight_m / 16.0;
    for (std::size_t i = 0; i < m_short.size(); ++i) {
        if (ringWeight[m_shortRing[i]] > 0.0) {
            energy_m2[i] += total_m2 * ring[m_shortRing[i]] * weight[i] / ringWeight[m_shortRing[i]];
        }
    }
}

}  // namespace sagara::core
