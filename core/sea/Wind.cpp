#include "core/sea/Wind.h"

#include <algorithm>
#include <cmath>

#include "core/base/Random.h"
#include "core/base/Trig.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr std::size_t kSlow = 8;  // harmonics that also turn the wind
constexpr double kDirectionPerGustiness_rad = 8.0 * kDegree_rad / 0.15;

/// f S(f) at 10 m/s, up to a constant. Davenport's without his constants: recorded exercises know these bits.
double energyPerStep(GustSpectrum spectrum, double frequency_Hz) {
    if (spectrum != GustSpectrum::Davenport) return frequency_Hz * gustDensity(spectrum, frequency_Hz, 10.0);
    const double x = 1200.0 * frequency_Hz / 10.0;
    return x * x / std::pow(1.0 + x * x, 4.0 / 3.0);
}

}  // namespace

GustTable::GustTable(std::uint64_t seed, GustSpectrum spectrum) : m_harmonics() {
    Random random(seed ^ 0x77696e6400000000ULL);
    const double first_Hz = 1.0 / 300.0, last_Hz = 1.0 / 4.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < kHarmonics; ++i) {
        const double place =
            (static_cast<double>(i) + random.uniform()) / kHarmonics;  // jitter: no repetition
        const double frequency_Hz = first_Hz * std::pow(last_Hz / first_Hz, place);
        const double energy =
            energyPerStep(spectrum, frequency_Hz);  // equal steps of ln f: energy per step is f S(f)
        m_harmonics[i] = {kTwoPi * frequency_Hz, std::sqrt(2.0 * energy), kTwoPi * random.uniform(),
                          kTwoPi * random.uniform()};
        variance += energy;
    }
    for (Harmonic& h : m_harmonics) h.amplitude /= std::sqrt(variance);
}

WindVelocity GustTable::at(const WindParameters& mean, SimTime time) const {
    double gust = 0.0, turn = 0.0, slowEnergy = 0.0;
    for (std::size_t i = 0; i < kHarmonics; ++i) {
        const Harmonic& h = m_harmonics[i];
        const double angle = h.omega_radps * time.seconds();
        gust += h.amplitude * sinCos(angle + h.speedPhase_rad).cos;
        if (i >= kSlow) continue;
        turn += h.amplitude * sinCos(angle + h.directionPhase_rad).cos;
        slowEnergy += 0.5 * h.amplitude * h.amplitude;
    }
    return {mean.speed_mps * std::max(0.0, 1.0 + mean.gustiness * gust),
            mean.windFrom_rad + kDirectionPerGustiness_rad * mean.gustiness * turn / std::sqrt(slowEnergy)};
}

}  // namespace sagara::core
