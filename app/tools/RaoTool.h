#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/tools/HullChoice.h"

namespace sagara::tools {

/// What `sagara-sim rao` was asked to do.
struct RaoOptions {
    HullChoice hull;
    std::optional<double> waveHeight_m;  ///< crest to trough; none: Lpp / 50
    double speed_mps = 0.0;
    double heading_deg = 180.0;        ///< heading minus the direction the waves travel to
    std::vector<double> omegas_radps;  ///< of the waves; or
    std::vector<double> lambdasOverLpp;
    bool timeDomain = false;  ///< measured by running the hull through the waves
    std::string csv = "-";
};

/// Motions in regular waves by strip theory, as CSV. Returns the exit code.
int runRao(const run::Store& store, const RaoOptions& options);

}  // namespace sagara::tools
