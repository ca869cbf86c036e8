#pragma once

#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/motion/Waterplane.h"
#include "core/sea/SeaState.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// The surface's height summed over a waterplane, and its halves against each other.
struct WaveHeights {
    double sum_m3 = 0.0;
    double along_m3 = 0.0;   ///< front half less rear half
    double across_m3 = 0.0;  ///< starboard half less port half
};
/// Of one unit wave sin(phase + kx a + ky b) over a rectangle: Sandaruwan et al. (2010), eq 10, 14 and 19, in
/// closed form.
WaveHeights waveHeights(const Waterplane& waterplane, double kx_radpm, double ky_radpm, double phase_rad);
/// Of the active components at the ship's place.
WaveHeights waveHeights(const Waterplane& waterplane, const ActiveWaves& waves, NorthEast position,
                        double heading_rad);

/// Heave, roll and pitch of the older simulators, which push a ship by the heights of the surface over a
/// rectangle: no pressure under waves, no added mass. As Ueng et al. (2008) with the ship's own attitude
/// taken off the heights and damping as shares of the critical, so that she floats; or as printed in
/// Sandaruwan et al. (2010), eq 10 to 19, where nothing restores her: her answer to a wave grows with the
/// square of its period.
class HeightMotion {
public:
    HeightMotion(const TransferModel& model, const Vessel& vessel);
    /// Replaces the rates of heave, roll and pitch. `external`: loads but those of waves.
    void apply(const ShipMotion& m, const Load& external, const WaveHeights& heights, ShipMotion& rate) const;

private:
    void applyPrinted(const ShipMotion& m, const WaveHeights& heights, ShipMotion& rate) const;

    TransferModel m_model;
    Waterplane m_plane;
    double m_density_kgpm3, m_mass_kg;
    double m_pitchInertia_kgm2, m_rollInertia_kgm2;
    double m_heaveDamping, m_pitchDamping, m_rollDamping;  ///< SI
};

}  // namespace sagara::core
