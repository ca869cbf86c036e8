#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <string>

#include "core/base/Problems.h"

/// What the readers of GDAL data share. Included by their .cpp files only.
namespace sagara::importer {

/// The file, opened for reading with one named driver. Null after a problem.
GDALDatasetUniquePtr openDataset(const std::filesystem::path& file, unsigned kind, const char* driver,
                                 core::config::Problems& problems);

/// Whether these are degrees on WGS 84; if not, a problem is noted.
bool isWgs84(const OGRSpatialReference* reference, core::config::Problems& problems);

}  // namespace sagara::importer
