#pragma once

#include <vector>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"

namespace sagara::tools {

/// What `sagara-sim wind-load` was asked to do.
struct WindLoadOptions {
    VesselChoice ship;
    double wind_mps = 10.0;
    std::vector<double> from_deg;  ///< off the bow, 90 from starboard; none: every 10 deg to 180
    std::string csv = "-";
};

/// Writes coefficients and loads of a relative wind by the method of her document, frame B about midship.
/// Returns the exit code.
int runWindLoad(const run::Store& store, const WindLoadOptions& options);

}  // namespace sagara::tools
