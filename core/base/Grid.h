#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/Planar.h"

namespace sagara::core {

/// Values on a square raster in frame N. Row 0 is the southernmost, column 0 the westernmost; a value belongs
/// to its node, not to a cell. Invariant: rows and columns at least 2, spacing_m > 0, values.size() == rows *
/// columns.
class Grid {
public:
    Grid(NorthEast southWest, double spacing_m, std::size_t rows, std::size_t columns,
         std::vector<float> values)
        : m_southWest(southWest),
          m_spacing_m(spacing_m),
          m_rows(rows),
          m_columns(columns),
          m_values(std::move(values)) {
        assert(rows >= 2 && columns >= 2 && spacing_m > 0.0 && m_values.size() == rows * columns);
    }

    NorthEast southWest() const { return m_southWest; }
    double spacing_m() const { return m_spacing_m; }
    std::size_t rows() const { return m_rows; }
    std::size_t columns() const { return m_columns; }
    const std::vector<float>& values() const { return m_values; }
    NorthEast node(std::size_t row, std::size_t column) const {
        return m_southWest +
               NorthEast{m_spacing_m * static_cast<double>(row), m_spacing_m * static_cast<double>(column)};
    }

    bool covers(NorthEast p) const {
        const NorthEast d = p - m_southWest;
        return d.north_m >= 0.0 && d.east_m >= 0.0 &&
               d.north_m <= m_spacing_m * static_cast<double>(m_rows - 1) &&
               d.east_m <= m_spacing_m * static_cast<double>(m_columns - 1);
    }

    /// Bilinear; outside the raster the value of the nearest edge.
    double at(NorthEast p) const {
        const Cell row = cell((p.north_m - m_southWest.north_m) / m_spacing_m, m_rows);
        const Cell column = cell((p.east_m - m_southWest.east_m) / m_spacing_m, m_columns);
        const std::size_t i = row.index * m_columns + column.index;
        const double south = mix(m_values[i], m_values[i + 1], column.fraction);
        const double north = mix(m_values[i + m_columns], m_values[i + m_columns + 1], column.fraction);
        return south + (north - south) * row.fraction;
    }

private:
    struct Cell {
        std::size_t index;
        double fraction;
    };
    static Cell cell(double position, std::size_t nodes) {
        const double inside = std::clamp(position, 0.0, static_cast<double>(nodes - 1));
        const auto index = std::min(static_cast<std::size_t>(inside), nodes - 2);
        return {index, inside - static_cast<double>(index)};
    }
    static double mix(float a, float b, double fraction) {
        return static_cast<double>(a) + (static_cast<double>(b) - static_cast<double>(a)) * fraction;
    }

    NorthEast m_southWest;
    double m_spacing_m;
    std::size_t m_rows;
    std::size_t m_columns;
    std::vector<float> m_values;
};

}  // namespace sagara::core
