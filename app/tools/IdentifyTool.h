#pragma once

#include <string>
#include <vector>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"

namespace sagara::tools {

/// What `sagara-sim identify` was asked to do.
struct IdentifyOptions {
    VesselChoice ship;
    std::string trials;            ///< folder
    std::string out;               ///< the fitted vessel document
    std::vector<std::string> fit;  ///< groups; empty: all of the model
    std::string report;            ///< coefficients as CSV; empty: none
};

/// Fits a vessel to her trials, prints what was found and how well it is known, writes her document. Returns
/// the exit code.
int runIdentify(const run::Store& store, const IdentifyOptions& options);

}  // namespace sagara::tools
