#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/import/ImportDescription.h"
#include "core/base/LocalFrame.h"
#include "core/base/Problems.h"

namespace sagara::importer {

/// A raster of heights above mean sea level in WGS 84 degrees, north up (a GeoTIFF).
class ElevationSource {
public:
    /// Nothing after a problem. The raster must cover the box.
    static std::optional<ElevationSource> read(const std::filesystem::path& file, const GeoBox& box,
                                               core::config::Problems& problems);
    /// Bilinear between cell centres; beyond the raster its edge.
    double height_m(core::GeoPoint p) const;

private:
    double m_north_deg = 0.0;  ///< centre of the first cell
    double m_west_deg = 0.0;
    double m_cellHeight_deg = 0.0;
    double m_cellWidth_deg = 0.0;
    std::size_t m_rows = 0;  ///< from north to south
    std::size_t m_columns = 0;
    std::vector<double> m_heights_m;
};

}  // namespace sagara::importer
