#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/Store.h"

namespace sagara::station {

/// A run of which the database knows no end: the program was killed, or the machine went down.
struct BrokenOff {
    std::filesystem::path recording;
    std::string scenarioName;
    std::string trainee;  ///< empty: nobody named
    core::Utc started;
    double sailed_s = 0.0;  ///< saved up to here
    bool canGoOn = false;   ///< by this build
};

/// Those whose recording is still there and not being written, newest first; a few at most.
std::vector<BrokenOff> brokenOffRuns(run::Store& store);

}  // namespace sagara::station
