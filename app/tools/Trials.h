#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/identify/SeaTrial.h"

namespace sagara::tools {

/// All *.csv of a folder, by name. The error is for the person who asked: all problems of all files.
core::Result<std::vector<core::SeaTrial>, std::string> readTrials(const std::filesystem::path& folder);

}  // namespace sagara::tools
