#pragma once

#include <complex>
#include <vector>

#include "core/seakeeping/SectionPanels.h"

/// The flow about one cross-section that heaves, sways or rolls in deep water with a free surface.
namespace sagara::core {

/// Potential on each panel of the half section y > 0 per unit velocity of the section, with exp(+i w t):
/// heave is the same on the other half, sway and roll have the other sign there. Roll is about the waterline
/// on the centreline.
struct SectionFlow {
    std::vector<std::complex<double>> sway_m;
    std::vector<std::complex<double>> heave_m;
    std::vector<std::complex<double>> roll_m2;
};

/// Green's third identity on straight panels of constant potential with Frank's pulsating source, which is
/// integrated over each panel exactly. Points on the waterplane inside the hull, where the identity must give
/// nothing, are added by least squares: they suppress the irregular frequencies. `waveNumber_radpm` is w^2/g;
/// 0 gives the limits of sway and roll at low frequency (heave is then that of a section under a wall and of
/// no use), infinity those of all at high frequency.
SectionFlow flowAbout(const std::vector<SectionPanel>& panels, double waveNumber_radpm);

/// Per metre of length and per unit density: force = -(i w a + b) velocity. Sway and roll about the waterline
/// with y and roll axis such that y turns into z. Damping is given as b / w.
struct SectionCoefficients {
    double sway_m2 = 0.0;
    double heave_m2 = 0.0;
    double roll_m4 = 0.0;
    double swayRoll_m3 = 0.0;
};
struct SectionRadiation {
    SectionCoefficients addedMass;
    SectionCoefficients dampingOverOmega;
};
SectionRadiation radiationOf(const std::vector<SectionPanel>& panels, const SectionFlow& flow);

}  // namespace sagara::core
