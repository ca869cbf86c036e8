#pragma once

#include "core/identify/SeaTrial.h"

namespace sagara::core {

/// The two numbers of Nomoto et al. (1957), T r' + r = K (delta - delta0), that describe the records of a
/// ship best, whatever model she is run with: at the speed and amplitude of these trials.
struct NomotoFit {
    double gain_perS = 0.0, gainDeviation_perS = 0.0;
    double timeConstant_s = 0.0, timeDeviation_s = 0.0;
    double speed_mps = 0.0;    ///< of the approach, mean over the trials
    double heading_rad = 0.0;  ///< root mean square of what is left
    std::vector<std::string> trials;
};

/// From all zigzags with a rudder column and headings or yaw rates; without any, from such turns (of which T
/// is little told). None where there are none.
std::optional<NomotoFit> fitNomoto(const std::vector<SeaTrial>& trials, double length_m);

}  // namespace sagara::core
