#pragma once

#include <vector>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"

namespace sagara::tools {

/// What `sagara-sim forces` was asked to do.
struct ForcesOptions {
    VesselChoice ship;
    std::vector<double> state;      ///< u, v, r, phi, p in m/s, rad/s and rad; those left out are 0
    double rudder_deg = 0.0;        ///< positive to starboard
    std::vector<double> shaft_rps;  ///< of each shaft; one for all
    std::string csv = "-";
};

/// Writes the forces of hull, propellers and rudders on a ship in a state of motion, and her accelerations:
/// one row. Frame B about midship. Returns the exit code.
int runForces(const run::Store& store, const ForcesOptions& options);

}  // namespace sagara::tools
