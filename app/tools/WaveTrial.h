#pragma once

#include "core/motion/ShipDynamics.h"

namespace sagara::tools {

/// How a vessel answers a regular wave at rest, as an exercise moves her, held on her heading in the waves of
/// one place.
struct WaveAnswer {
    // First harmonic over the wave's amplitude, or over its slope.
    double heave = 0.0;
    double roll_k = 0.0;
    double pitch_k = 0.0;
    double risePerPeriod =
        0.0;  ///< mean heave gained each period, over the wave's amplitude: 0 for one that floats
};

/// Heading less the direction the wave travels to: 180 deg is a head sea.
WaveAnswer answerToWave(const core::ShipDynamics& ship, double omega_radps, double relativeHeading_rad,
                        double amplitude_m);

}  // namespace sagara::tools
