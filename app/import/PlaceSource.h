#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/LocalFrame.h"
#include "core/base/Problems.h"

namespace sagara::importer {

struct SourcePlace {
    std::string id;
    std::string name;
    std::string kind;
    std::string confidence;  ///< may be empty
    core::GeoPoint at;
};

/// The points of a GeoJSON file that have a position, with the properties id, name, class and confidence.
std::vector<SourcePlace> readPlaces(const std::filesystem::path& file, core::config::Problems& problems);

}  // namespace sagara::importer
