#include "core/sea/SeaState.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/Trig.h"

namespace sagara::core {

void raiseSea(const WaveTable& table, SeaState& sea) {
    std::vector<double> energy_m2(table.components().size(), 0.0);
    for (const SeaSystem& system : sea.systems) table.addEnergy(system, energy_m2);
    const double total_m2 = std::accumulate(energy_m2.begin(), energy_m2.end(), 0.0);

    std::vector<std::uint16_t> order(energy_m2.size());
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return energy_m2[a] > energy_m2[b]; });
    std::size_t kept = 0;
    double kept_m2 = 0.0;
    while (kept < std::min(order.size(), kMostActiveComponents) && kept_m2 < kActiveEnergyShare * total_m2) {
        kept_m2 += energy_m2[order[kept++]];
    }
    const double raise = kept_m2 > 0.0 ? total_m2 / kept_m2 : 0.0;
    sea.active.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept));
    sea.amplitude_m.clear();
    for (const std::uint16_t i : sea.active) sea.amplitude_m.push_back(std::sqrt(2.0 * energy_m2[i] * raise));
}

void activeWaves(const WaveTable& table, const SeaState& sea, SimTime time, ActiveWaves& waves) {
    waves.count = sea.active.size();
    for (std::size_t i = 0; i < waves.count; ++i) {
        const WaveComponent& c = table.components()[sea.active[i]];
        waves.kNorth_radpm[i] = c.kNorth_radpm;
        waves.kEast_radpm[i] = c.kEast_radpm;
        waves.omega_radps[i] = c.omega_radps;
        waves.phase_rad[i] = c.phase_rad - c.omega_radps * time.seconds();
        waves.amplitude_m[i] = sea.amplitude_m[i];
    }
}

double longElevation_m(const ActiveWaves& waves, NorthEast p) {
    double sum_m = 0.0;
    for (std::size_t i = 0; i < waves.count; ++i) {
        const double angle =
            waves.kNorth_radpm[i] * p.north_m + waves.kEast_radpm[i] * p.east_m + waves.phase_rad[i];
        sum_m += waves.amplitude_m[i] * sinCos(angle).cos;
    }
    return sum_m;
}

SeaSurface::SeaSurface(const WaveTable& table, const SeaState& sea) {
    for (std::size_t i = 0; i < sea.active.size(); ++i) {
        m_waves.push_back({table.components()[sea.active[i]], sea.amplitude_m[i]});
    }
    std::vector<double> energy_m2(table.shortComponents().size(), 0.0);
    for (const SeaSystem& system : sea.systems) table.addShortEnergy(system, energy_m2);
    for (std::size_t i = 0; i < energy_m2.size(); ++i) {
        if (energy_m2[i] > 0.0)
            m_waves.push_back({table.shortComponents()[i], std::sqrt(2.0 * energy_m2[i])});
    }
}

double SeaSurface::elevation_m(NorthEast p, SimTime time) const {
    double sum_m = 0.0;
    for (const Wave& w : m_waves) {
        const WaveComponent& c = w.component;
        const double angle = c.kNorth_radpm * p.north_m + c.kEast_radpm * p.east_m -
                             c.omega_radps * time.seconds() + c.phase_rad;
        sum_m += w.amplitude_m * sinCos(angle).cos;
    }
    return sum_m;
}

}  // namespace sagara::core
