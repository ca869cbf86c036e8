#pragma once

#include <array>
#include <cstdint>

#include "core/base/SimTime.h"
#include "core/sea/WindSpectrum.h"

namespace sagara::core {

/// The wind as the weather report gives it: mean at 10 m height.
struct WindParameters {
    double speed_mps = 0.0;
    double windFrom_rad = 0.0;
    double gustiness = 0.0;  ///< standard deviation of speed over the mean; about 0.15 at sea

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.speed_mps, self.windFrom_rad, self.gustiness);
    }
    friend bool operator==(const WindParameters&, const WindParameters&) = default;
};

/// The wind of this moment.
struct WindVelocity {
    double speed_mps = 0.0;
    double windFrom_rad = 0.0;
};

/// Gusts as a sum of harmonics with seeded phases: a pure function of time, so no memory in State. Shape: a
/// published spectrum at 10 m/s, 24 harmonics from 300 s to 4 s; direction wanders with the slow third of
/// them, 8 deg rms for gustiness 0.15.
class GustTable {
public:
    explicit GustTable(std::uint64_t seed, GustSpectrum spectrum = GustSpectrum::Davenport);
    WindVelocity at(const WindParameters& mean, SimTime time) const;

private:
    static constexpr std::size_t kHarmonics = 24;
    struct Harmonic {
        double omega_radps;
        double amplitude;
        double speedPhase_rad;
        double directionPhase_rad;
    };
    std::array<Harmonic, kHarmonics> m_harmonics;
};

}  // namespace sagara::core
