#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Problems.h"
#include "core/base/Result.h"

namespace sagara::importer {

struct ImportedArea {
    std::string document;             ///< the area document, which core::loadArea accepts
    std::vector<std::string> report;  ///< what a person should look at: what was left out, how the depths fit
};

/// Reads the description and its sources, runs the models, writes the document. Source files are named
/// relative to `folder`. Nothing is written to disk here.
core::Result<ImportedArea, core::config::Problems> importArea(const std::string& name,
                                                              std::string_view description,
                                                              const std::filesystem::path& folder);

/// The same from file to file; the output appears whole or not at all. Empty problems mean success.
core::config::Problems importAreaFile(const std::filesystem::path& description,
                                      const std::filesystem::path& out, std::vector<std::string>& report);

}  // namespace sagara::importer
