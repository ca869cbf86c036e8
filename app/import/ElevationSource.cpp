#include "app/import/ElevationSource.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/import/Gdal.h"
#include "core/base/Config.h"

namespace sagara::importer {
namespace {

using core::config::formatNumber;
using core::config::Problems;

std::string describe(const GeoBox& b) {
    return formatNumber(b.south_deg) + " to " + formatNumber(b.north_deg) + " N, " +
           formatNumber(b.west_deg) + " to " + formatNumber(b.east_deg) + " E";
}

/// Heights of the only band, with "no data" read as sea.
std::vector<double> readBand(GDALDataset& dataset, Problems& problems) {
    GDALRasterBand* band = dataset.GetRasterBand(1);
    const int columns = band->GetXSize(), rows = band->GetYSize();
    std::vector<double> heights_m(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    if (band->RasterIO(GF_Read, 0, 0, columns, rows, heights_m.data(), columns, rows, GDT_Float64, 0, 0) !=
        CE_None) {
        problems.add({"", std::string("cannot be read (") + CPLGetLastErrorMsg() + ")", "a whole GeoTIFF"});
    }
    int hasNoData = 0;
    const double noData = band->GetNoDataValue(&hasNoData);
    for (double& h : heights_m) {
        if (!std::isfinite(h) || (hasNoData && h == noData)) h = 0.0;
    }
    return heights_m;
}

struct Cell {
    std::size_t index;
    double fraction;
};
Cell cell(double position, std::size_t nodes) {
    const double inside = std::clamp(position, 0.0, static_cast<double>(nodes - 1));
    const auto index = std::min(static_cast<std::size_t>(inside), nodes - 2);
    return {index, inside - static_cast<double>(index)};
}

}  // namespace

std::optional<ElevationSource> ElevationSource::read(const std::filesystem::path& file, const GeoBox& box,
                                                     Problems& all) {
    Problems problems(file.filename().string());
    ElevationSource source;
    const GDALDatasetUniquePtr dataset = openDataset(file, GDAL_OF_RASTER, "GTiff", problems);
    if (dataset && isWgs84(dataset->GetSpatialRef(), problems)) {
        std::array<double, 6> t{};
        const bool northUp =
            dataset->GetGeoTransform(t.data()) == CE_None && t[2] == 0.0 && t[4] == 0.0 && t[5] < 0.0;
        source.m_columns = static_cast<std::size_t>(dataset->GetRasterXSize());
        source.m_rows = static_cast<std::size_t>(dataset->GetRasterYSize());
        const bool whole =
            northUp && dataset->GetRasterCount() == 1 && source.m_rows > 1 && source.m_columns > 1;
        if (!whole) problems.add({"", "is no height raster", "one band, north up, at least 2 by 2 cells"});
        source.m_cellWidth_deg = t[1];
        source.m_cellHeight_deg = -t[5];
        source.m_west_deg = t[0] + 0.5 * t[1];
        source.m_north_deg = t[3] + 0.5 * t[5];
        const GeoBox found{
            source.m_north_deg - source.m_cellHeight_deg * static_cast<double>(source.m_rows - 1),
            source.m_west_deg, source.m_north_deg,
            source.m_west_deg + source.m_cellWidth_deg * static_cast<double>(source.m_columns - 1)};
        if (whole && !found.covers(box))
            problems.add({"", "covers " + describe(found), "at least " + describe(box)});
        if (whole) source.m_heights_m = readBand(*dataset, problems);
    }
    if (problems.empty()) return source;
    all.append(problems);
    return std::nullopt;
}

double ElevationSource::height_m(core::GeoPoint p) const {
    const Cell row = cell((m_north_deg - p.lat_deg) / m_cellHeight_deg, m_rows);
    const Cell column = cell((p.lon_deg - m_west_deg) / m_cellWidth_deg, m_columns);
    const double* at = m_heights_m.data() + row.index * m_columns + column.index;
    const double north_m = at[0] + (at[1] - at[0]) * column.fraction;
    const double south_m = at[m_columns] + (at[m_columns + 1] - at[m_columns]) * column.fraction;
    return north_m + (south_m - north_m) * row.fraction;
}

}  // namespace sagara::importer
