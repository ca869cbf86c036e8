#pragma once

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"
#include "core/identify/Decay.h"

namespace sagara::tools {

/// What `sagara-sim decay` was asked to do.
struct DecayOptions {
    VesselChoice ship;
    core::Decay::Dof dof = core::Decay::Dof::Roll;
    double start = 0.0;  ///< deg, for heave m
    double speed_mps = 0.0;
    std::optional<double> duration_s;  ///< none: until the motion has died down
    std::optional<double> dt_s;        ///< between rows
    bool measures = false;
    std::string csv = "-";
};

/// Lets a ship go from a heel, trim or immersion in calm water, and writes her motion or period and damping.
/// Returns the exit code.
int runDecayTool(const run::Store& store, const DecayOptions& options);

}  // namespace sagara::tools
