#include "app/import/Raster.h"

#include <algorithm>
#include <cmath>

namespace sagara::importer {
namespace {

using core::NorthEast;

/// Eastings at which a parallel of frame N crosses the ring, in order.
std::vector<double> crossings(const Ring& ring, double north_m) {
    std::vector<double> easts_m;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const NorthEast a = ring[i], b = ring[j];
        if ((a.north_m > north_m) == (b.north_m > north_m)) continue;
        easts_m.push_back(a.east_m + (b.east_m - a.east_m) * (north_m - a.north_m) / (b.north_m - a.north_m));
    }
    std::sort(easts_m.begin(), easts_m.end());
    return easts_m;
}

void fillRow(const Raster& raster, std::size_t row, const Ring& ring, std::vector<char>& inside) {
    const std::vector<double> easts_m = crossings(ring, raster.node(row, 0).north_m);
    for (std::size_t i = 0; i + 1 < easts_m.size(); i += 2) {
        for (std::size_t column = 0; column < raster.columns; ++column) {
            const double east_m = raster.node(row, column).east_m;
            if (east_m >= easts_m[i] && east_m < easts_m[i + 1]) inside[row * raster.columns + column] = 1;
        }
    }
}

}  // namespace

Raster rasterInside(const GridRules& rules, const core::LocalFrame& frame) {
    const GeoBox& box = rules.box;
    const NorthEast sw = frame.toLocal({box.south_deg, box.west_deg}),
                    se = frame.toLocal({box.south_deg, box.east_deg});
    const NorthEast nw = frame.toLocal({box.north_deg, box.west_deg}),
                    ne = frame.toLocal({box.north_deg, box.east_deg});
    const double south_m = std::ceil(std::max(sw.north_m, se.north_m)) + 1.0;
    const double west_m = std::ceil(std::max(sw.east_m, nw.east_m)) + 1.0;
    const double height_m = std::floor(std::min(nw.north_m, ne.north_m)) - 1.0 - south_m;
    const double width_m = std::floor(std::min(se.east_m, ne.east_m)) - 1.0 - west_m;
    const auto nodes = [&](double side_m) {
        return side_m < rules.spacing_m ? std::size_t{1}
                                        : static_cast<std::size_t>(side_m / rules.spacing_m) + 1;
    };
    return {{south_m, west_m}, rules.spacing_m, nodes(height_m), nodes(width_m)};
}

std::vector<char> nodesInside(const Raster& raster, const std::vector<Ring>& rings) {
    std::vector<char> inside(raster.size(), 0);
    for (const Ring& ring : rings) {
        for (std::size_t row = 0; row < raster.rows; ++row) fillRow(raster, row, ring, inside);
    }
    return inside;
}

}  // namespace sagara::importer
