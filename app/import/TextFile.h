#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/Problems.h"

namespace sagara::importer {

/// The whole file, or nothing and a problem under the file's name.
std::optional<std::string> readTextFile(const std::filesystem::path& file, core::config::Problems& problems);

/// The whole text or nothing: written beside the file under another name, then renamed. An existing file is
/// replaced. False after a problem.
bool writeWholeFile(const std::filesystem::path& file, std::string_view text,
                    core::config::Problems& problems);

}  // namespace sagara::importer
