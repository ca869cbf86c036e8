#pragma once

#include <functional>

#include "app/tools/ValidationCase.h"

namespace sagara::tools {

/// A case that was run.
struct ValidationResult {
    std::string id;  ///< name of its file
    std::string title;
    std::string evidence;  ///< verification, validation or trend
    std::string source;
    std::string note;  ///< where it is claimed and why not elsewhere; empty: everywhere
    ValidationOutcome outcome;
};

/// Ids of the cases in a folder, sorted.
std::vector<std::string> validationIds(const std::filesystem::path& folder);
/// Reads and runs one. All problems of its document at once.
core::Result<ValidationResult, core::config::Problems> runValidation(const ValidationContext& context,
                                                                     const std::string& id);

}  // namespace sagara::tools
