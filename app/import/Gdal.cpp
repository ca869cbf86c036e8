#include "app/import/Gdal.h"

#include <mutex>

namespace sagara::importer {
namespace {

/// GDAL's registry is global; its own messages are quiet because ours say more.
void registerDrivers() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        CPLSetErrorHandler(CPLQuietErrorHandler);
    });
}

}  // namespace

GDALDatasetUniquePtr openDataset(const std::filesystem::path& file, unsigned kind, const char* driver,
                                 core::config::Problems& problems) {
    registerDrivers();
    if (!std::filesystem::is_regular_file(file)) {
        problems.add({"", "is missing", "a file at " + file.string()});
        return nullptr;
    }
    const char* const drivers[] = {driver, nullptr};
    CPLErrorReset();
    GDALDatasetUniquePtr dataset(
        GDALDataset::Open(file.c_str(), GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR | kind, drivers));
    const std::string why = CPLGetLastErrorMsg();
    if (!dataset) problems.add({"", "cannot be read" + (why.empty() ? "" : " (" + why + ")"), driver});
    return dataset;
}

bool isWgs84(const OGRSpatialReference* reference, core::config::Problems& problems) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    const bool same = reference && reference->IsGeographic() && reference->IsSameGeogCS(&wgs84);
    const char* const name = reference ? reference->GetName() : nullptr;
    if (!same) {
        problems.add({"", std::string("has the reference system ") + (name ? name : "none"),
                      "WGS 84 degrees (EPSG:4326)"});
    }
    return same;
}

}  // namespace sagara::importer
