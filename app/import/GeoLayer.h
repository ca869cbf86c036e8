#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/LocalFrame.h"
#include "core/base/Problems.h"

namespace sagara::importer {

enum class GeoShape { Point, Line, Polygon };

/// One feature of a GeoJSON file with its text properties; properties that are null are absent. A
/// multi-geometry has several parts. Rings are closed: the first point is not repeated.
struct GeoFeature {
    std::string path;  ///< "features[3]", for messages
    std::vector<std::vector<core::GeoPoint>> parts;
    std::map<std::string, std::string> properties;

    std::string property(const std::string& key) const;  ///< empty when absent
};

/// All features of a GeoJSON file in WGS 84; those without geometry are left out. Whatever is not of the
/// wanted shape, a polygon with a hole among it, is a problem.
std::vector<GeoFeature> readGeoLayer(const std::filesystem::path& file, GeoShape shape,
                                     core::config::Problems& problems);

}  // namespace sagara::importer
