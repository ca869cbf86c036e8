#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/Planar.h"
#include "core/base/SimTime.h"
#include "core/sea/Spectrum.h"

namespace sagara::core {

/// Two limits of wave number and the square tile whose lattice carries the waves between them.
struct WaveBand {
    double tile_m;
    double low_radpm;
    double high_radpm;
    double step_radpm() const;
};

/// The three nested lattices of the one sea (design.md, section 5): 128 x 128 points each, disjoint bands.
/// The two long bands reach from waves of 800 m to 6.3 m, which is what ships feel; the short one gives the
/// picture its skin.
inline constexpr std::size_t kLatticeSize = 128;
inline constexpr std::array<WaveBand, 3> kWaveBands{{
    {1200.0, 0.00785, 0.16},
    {160.0, 0.16, 1.0},
    {25.0, 1.0, 15.0},
}};

/// One sinusoid: a cos(k . x - omega t + phase), x in frame N. Its wave number is a point of its band's
/// lattice, so the renderer can draw it with one inverse FFT and a ship can feel it in closed form.
struct WaveComponent {
    double kNorth_radpm = 0.0;
    double kEast_radpm = 0.0;
    double omega_radps = 0.0;
    double phase_rad = 0.0;
    std::uint8_t band = 0;
};

/// Wave numbers, frequencies and phases of an exercise: all of the sea that weather does not change. In the
/// long bands the wave-number plane is cut into polar cells (31 rings, 36 directions); the energy of a cell
/// stands on one lattice point near its middle, and the other points are still. So what is drawn is what is
/// felt, not a sample of it. In the short band every lattice point moves.
class WaveTable {
public:
    /// depth_m: representative depth of the area, for the dispersion of all waves.
    WaveTable(std::uint64_t seed, double depth_m);
    /// A table of one component, which need not be a lattice point: a regular wave for tests and response
    /// curves. It has no cells, so addEnergy adds nothing: set the amplitude in SeaState.
    static WaveTable regular(double omega_radps, double wavesTo_rad, double depth_m);

    const std::vector<WaveComponent>& components() const { return m_long; }
    /// Those of the short band, for drawing and probing.
    const std::vector<WaveComponent>& shortComponents() const { return m_short; }
    double depth_m() const { return m_depth_m; }

    /// Energy (half the squared amplitude, m^2) of every long component in a sea of these systems, added to
    /// `energy_m2`, which has components().size() entries. The energies of long and short components together
    /// are Hs^2 / 16.
    void addEnergy(const SeaSystem& system, std::vector<double>& energy_m2) const;
    /// The same for the short band.
    void addShortEnergy(const SeaSystem& system, std::vector<double>& energy_m2) const;

private:
    explicit WaveTable(double depth_m) : m_depth_m(depth_m) {}
    static constexpr std::size_t kDirections = 36;
    struct Ring {
        double low_radpm;
        double high_radpm;
        std::uint8_t band;
    };
    /// Share of the system's energy in each ring, short rings included; sums to 1.
    std::vector<double> ringShares(const SeaSystem& system) const;
    void addLongCell(std::size_t ring, std::size_t direction, class Random& random);

    double m_depth_m;
    std::vector<Ring> m_rings;
    std::size_t m_longRings = 0;
    std::vector<WaveComponent> m_long;
    std::vector<WaveComponent> m_short;
    std::vector<std::uint16_t> m_cellComponent;  ///< [ring * kDirections + direction] -> index in m_long
    std::vector<std::uint16_t> m_shortRing;      ///< ring of every short component
};

}  // namespace sagara::core
