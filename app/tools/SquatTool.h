#pragma once

#include <optional>
#include <vector>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"

namespace sagara::tools {

/// What `sagara-sim squat` was asked to do.
struct SquatToolOptions {
    VesselChoice ship;
    std::vector<double> speed_mps;
    std::optional<double> width_m;  ///< of the channel; none: open water
    std::string csv = "-";
};

/// Writes the largest sinkage by every formula known, one row for each speed. Returns the exit code.
int runSquatTool(const run::Store& store, const SquatToolOptions& options);

}  // namespace sagara::tools
