#pragma once

#include <filesystem>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"

namespace sagara::tools {

/// What `sagara-sim pilot-card` was asked to do.
struct PilotCardOptions {
    VesselChoice ship;  ///< its depth is that of the shallow condition; none: 1.2 of the draught
    std::filesystem::path pdf;
};

/// Runs the standard manoeuvres loaded and in ballast, in deep and in shallow water, and writes the pilot
/// card and wheelhouse poster. Returns the exit code.
int runPilotCard(const run::Store& store, const PilotCardOptions& options);

}  // namespace sagara::tools
