#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/import/ImportDescription.h"
#include "core/base/Problems.h"

namespace sagara::importer {

struct TideConstants {
    struct Constituent {
        std::string name;
        double amplitude_m = 0.0;
        double phaseLag_deg = 0.0;
    };
    double meanAboveDatum_m = 0.0;  ///< mean sea level over lowest astronomical tide
    std::vector<Constituent> constituents;
    std::vector<std::string> unknown;  ///< left out: the simulator has no argument for them
    std::vector<std::string> small;    ///< left out: below the least amplitude
};

/// Harmonic constants in the JSON of the Neaps tide database (TICON).
TideConstants readTide(const std::filesystem::path& file, const TideRules& rules,
                       core::config::Problems& problems);

}  // namespace sagara::importer
