#pragma once

#include <cstddef>
#include <vector>

#include "app/import/ImportDescription.h"
#include "core/base/Planar.h"

namespace sagara::importer {

using Ring = std::vector<core::NorthEast>;  ///< closed, first point not repeated

/// Where the nodes of a grid lie before there are values; the convention of core::Grid.
struct Raster {
    core::NorthEast southWest;
    double spacing_m = 1.0;
    std::size_t rows = 0;
    std::size_t columns = 0;

    std::size_t size() const { return rows * columns; }
    core::NorthEast node(std::size_t row, std::size_t column) const {
        return southWest + spacing_m * core::NorthEast{static_cast<double>(row), static_cast<double>(column)};
    }
    core::NorthEast node(std::size_t index) const { return node(index / columns, index % columns); }
};

/// The largest raster of that spacing inside the box, a metre clear of its sides because parallels are not
/// straight in N.
Raster rasterInside(const GridRules& rules, const core::LocalFrame& frame);

/// For every node, whether it lies inside any of the rings. Row by row: as the scan line crosses the sides.
std::vector<char> nodesInside(const Raster& raster, const std::vector<Ring>& rings);

}  // namespace sagara::importer
