#pragma once

#include <string>

#include "app/tools/HullChoice.h"

namespace sagara::tools {

/// What `sagara-sim hydrostatics` was asked to do.
struct HydrostaticsOptions {
    HullChoice hull;
    std::string csv = "-";
};

/// Hydrostatics and righting levers as `name,value` rows, what was estimated or fitted as comments. Returns
/// the exit code.
int runHydrostatics(const run::Store& store, const HydrostaticsOptions& options);

}  // namespace sagara::tools
