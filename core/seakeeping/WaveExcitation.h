#pragma once

#include <vector>

#include "core/sea/SeaState.h"
#include "core/seakeeping/RadiationMemory.h"
#include "core/seakeeping/SeakeepingTables.h"

namespace sagara::core {

struct WaveForces {
    Six first{};
    Six mean{};                   ///< surge, sway and yaw only
    double waterSurge_mps = 0.0;  ///< of the water in the waves, in B, its mean over the hull
    double waterSway_mps = 0.0;
};

/// First-order wave forces on one ship at run time: Froude-Krylov and diffraction of the tables, resampled
/// once (cubic) on a grid so fine that straight lines between its points do, evenly spaced in the cosine of
/// the heading; what is odd in heading is divided by its sine, so that waves from port need no other case.
/// About 8 MB. The mean forces of `meanWaveForce` go with them. A pure function: nothing is remembered from
/// call to call.
class WaveExcitation {
public:
    explicit WaveExcitation(const SeakeepingTables& tables);

    /// Per metre of wave amplitude, see `SeakeepingTables`. Relative heading = heading - direction the waves
    /// travel to, any. Waves shorter than those of the tables fade out within a fifth of their frequency;
    /// longer ones go over to the static force. Astern as at rest.
    Complex6 amplitude(double waveNumber_radpm, double relativeHeading_rad, double speed_mps) const;

    /// Sums over the components at Bo, first-order forces multiplied by the shelter of the place, mean forces
    /// by its square. The mean force is that of the sea as a whole: it does not come and go with groups of
    /// waves.
    WaveForces force(const ActiveWaves& waves, NorthEast position, double heading_rad, double speed_mps,
                     double shelter) const;

private:
    static constexpr std::size_t kCosines = 65;
    static constexpr std::size_t kRefined = 2;  ///< steps for one of the tables' frequencies
    static constexpr std::size_t kBetween = 3;  ///< steps from one of the tables' speeds to the next
    static constexpr std::size_t kParts =
        16;  ///< six real, six imaginary, three of the mean force, mean velocity over that of the surface
    struct Place {
        std::size_t first;  ///< of kParts values at the corner of lower speed, cosine and frequency
        float weight[8];    ///< speed, cosine, frequency; the last runs fastest
    };
    void fillBetween();
    Place placeOf(double waveNumber_radpm, double cosine, std::size_t speed, double speedShare) const;
    void blend(const Place& place, double* parts) const;
    std::size_t speedBelow(double speed_mps, double& share) const;

    double m_stillPitch_Nm;         ///< per metre, of the longest waves
    double m_shortest_radpm = 0.0;  ///< nothing is felt of waves beyond
    std::size_t m_frequencies = 0;
    double m_perFrequency = 0.0;  ///< grid steps per rad/s
    std::size_t m_cosineStride = 0;
    std::size_t m_speedStride = 0;
    std::vector<double> m_speeds_mps;
    std::vector<float> m_table;  ///< [speed][cosine][frequency][part]
};

}  // namespace sagara::core
