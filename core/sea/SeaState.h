#pragma once

#include <cstdint>
#include <vector>

#include "core/base/Planar.h"
#include "core/base/SimTime.h"
#include "core/sea/WaveTable.h"

namespace sagara::core {

/// The sea of one moment: which systems run and, worked out from them, the strongest components. Part of
/// State; made anew by `raiseSea` when the weather changes, never patched.
struct SeaState {
    std::vector<SeaSystem> systems;
    std::vector<std::uint16_t> active;  ///< indices into WaveTable::components(), strongest first
    std::vector<double> amplitude_m;    ///< of the active components, same order

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.systems, self.active, self.amplitude_m);
    }
};

/// Share of the long bands' energy the active components keep; the design asks for 95 % of what a ship can
/// feel.
inline constexpr double kActiveEnergyShare = 0.98;
inline constexpr std::size_t kMostActiveComponents = 320;

/// Fills `sea.active` and `sea.amplitude_m` from `sea.systems`. Amplitudes are raised so that the kept
/// components carry the energy of the dropped ones.
void raiseSea(const WaveTable& table, SeaState& sea);

/// The active components laid out for the sums of one tick, phases advanced to its time. Fixed size, on the
/// stack.
struct ActiveWaves {
    std::size_t count = 0;
    alignas(16) double kNorth_radpm[kMostActiveComponents];
    alignas(16) double kEast_radpm[kMostActiveComponents];
    alignas(16) double amplitude_m[kMostActiveComponents];
    alignas(16) double omega_radps[kMostActiveComponents];
    alignas(16) double phase_rad[kMostActiveComponents];  ///< of k . x + phase: phase_i - omega_i t
};
void activeWaves(const WaveTable& table, const SeaState& sea, SimTime time, ActiveWaves& waves);

/// Height of the long waves above still water, up positive, shelter not applied.
double longElevation_m(const ActiveWaves& waves, NorthEast p);

/// Everything that moves, with amplitudes: the surface as it is drawn. Made for a probe or a picture, not in
/// a tick.
class SeaSurface {
public:
    SeaSurface(const WaveTable& table, const SeaState& sea);
    /// Height above still water, up positive, shelter not applied.
    double elevation_m(NorthEast p, SimTime time) const;

    struct Wave {
        WaveComponent component;
        double amplitude_m;
    };
    const std::vector<Wave>& waves() const { return m_waves; }

private:
    std::vector<Wave> m_waves;
};

}  // namespace sagara::core
