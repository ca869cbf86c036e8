#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/Store.h"

namespace sagara::tools {

/// What `sagara-sim validate` was asked to do.
struct ValidateOptions {
    std::filesystem::path out = ".";  ///< folder for the report
    std::vector<std::string> cases;   ///< none: all of assets/validation
};

/// Exit code when all was run and written, and a number is out of its tolerance.
inline constexpr int kShortOfTolerance = 3;

/// Runs the validation cases, prints a row for each number and writes the report. Returns the exit code.
int runValidate(const run::Store& store, const ValidateOptions& options);

}  // namespace sagara::tools
