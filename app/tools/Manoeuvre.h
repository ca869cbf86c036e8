#pragma once

#include <optional>
#include <string>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"
#include "core/identify/Trial.h"

namespace sagara::tools {

/// What `sagara-sim manoeuvre` was asked to do.
struct ManoeuvreOptions {
    enum class Test { Turning, Zigzag, Spiral, ReverseSpiral, Stopping, Pullout };
    VesselChoice ship;
    Test test = Test::Turning;
    std::optional<double> rudder_deg;    ///< positive to starboard; none: usual for the test
    std::optional<double> heading_deg;   ///< at which a zigzag switches; none: as the rudder
    std::optional<bool> starboardFirst;  ///< a zigzag; none: by the sign of the rudder
    double look_s = 0.0;                 ///< see core::Zigzag
    std::optional<double> speed_mps;     ///< none: full ahead by telegraph
    std::optional<double> shaft_rps;     ///< none: what holds that speed
    std::optional<double> duration_s;    ///< none: as long as the measures need
    std::optional<double> dt_s;          ///< between rows, and the longest step of the integrator
    bool measures = false;               ///< printed instead of the run
    std::string csv = "-";
};

/// The manoeuvre of a vessel that has the model asked for (see openVessel).
core::Trial tryManoeuvre(const core::Vessel& vessel, const ManoeuvreOptions& options);

/// Runs a standard manoeuvre in calm water and writes its time series or its measures. Returns the exit code.
int runManoeuvre(const run::Store& store, const ManoeuvreOptions& options);

}  // namespace sagara::tools
