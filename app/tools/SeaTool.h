#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/sea/SeaOrder.h"

namespace sagara::tools {

/// What `sagara-sim sea` was asked to do.
struct SeaToolOptions {
    std::string spectrum = "jonswap";  ///< of SeaOrder, or "beaufort", "measured"
    core::SeaOrder order;
    double from_deg = 0.0;
    int beaufort = 5;
    bool inshore = false;
    std::string file;  ///< measured: a "waves" document
    int record = 0;
    double depth_m = 1e9;
    std::uint64_t seed = 1;
    std::vector<double> omega_radps;  ///< none: 100 from a third of the peak's frequency to four times it
    bool measures = false;
    std::string csv = "-";
};

/// Writes the spectrum, or with `measures` its statistics and those of the surface that Sagara makes of it.
/// Returns the exit code.
int runSeaTool(const SeaToolOptions& options);

}  // namespace sagara::tools
