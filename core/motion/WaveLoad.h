#pragma once

#include <vector>

#include "core/motion/HeightMotion.h"
#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/motion/Waterplane.h"
#include "core/sea/SeaState.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// What waves do to a ship. Up and down and in roll and pitch they push; in the horizontal plane they carry
/// her along: the water's own acceleration, averaged over the hull, is added to hers whatever her mass and
/// added mass are.
struct WaveEffect {
    Load load;  ///< heave, roll and pitch only
    double surge_mps2 = 0.0;
    double sway_mps2 = 0.0;
    double yaw_radps2 = 0.0;
    WaveHeights heights;  ///< alone, for the models that are pushed by them
};

/// First-order wave loads on one vessel: closed-form integrals of each component over the waterplane
/// (Waterplane.h), with the Smith effect, and with the acceleration and velocity of the water acting on added
/// mass and damping. Long waves therefore carry the ship as they carry a cork: heave equals the wave, roll
/// and pitch its slope. Diffraction is not in it; strip theory replaces this in a later model.
class WaveLoad {
public:
    /// Stiffness, added mass and damping that the vertical motion uses too (VerticalMotion.h).
    struct Coefficients {
        double heaveStiffness, heaveAddedMass, heaveDamping;
        double pitchStiffness, pitchAddedInertia, pitchDamping;
        double rollStiffness;
    };
    WaveLoad(const Vessel& vessel, const Coefficients& coefficients, const WaveTable& table,
             WaveFeeling feeling = WaveFeeling::Pressure);

    /// Sum over the active components at the ship's place, all multiplied by the shelter of that place.
    WaveEffect at(const SeaState& sea, const ActiveWaves& waves, NorthEast position, double heading_rad,
                  double shelter) const;

private:
    Waterplane m_waterplane;
    Coefficients m_c;
    WaveFeeling m_feeling;
    std::vector<double> m_smith;  ///< of every component of the table
};

/// Pressure under a wave at depth z over that at the surface: cosh k(h - z) / cosh kh, exp(-kz) in deep
/// water.
double smithFactor(double waveNumber_radpm, double z_m, double depth_m);

}  // namespace sagara::core
