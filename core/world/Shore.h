#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/Shapes.h"

namespace sagara::core {

/// What a piece of shoreline is made of, as far as a ship that hits it cares.
enum class ShoreKind : std::uint8_t { Quay, Jetty, Breakwater, Rock, Beach, Other };
const char* shoreKindName(ShoreKind kind);

/// One named stretch of shoreline.
struct ShoreLine {
    ShoreKind kind = ShoreKind::Other;
    std::string name;
    std::vector<NorthEast> points;
};

/// All shoreline of an area with an index by place. Immutable.
class Shore {
public:
    Shore() = default;
    /// `land`: closed rings that tell on which side of a line the water is.
    Shore(std::vector<ShoreLine> lines, const std::vector<std::vector<NorthEast>>& land);

    struct Piece {
        Segment segment;
        std::uint32_t line;  ///< index into lines()
        /// Unit vectors towards the water: of the piece, and of its ends, where they are the mean with the
        /// neighbour's.
        NorthEast toWater, toWaterA, toWaterB;
    };
    /// Distance from the piece to p, positive on the water side, and the point of the piece nearest to p.
    struct Offset {
        double distance_m;
        NorthEast nearest;
    };
    static Offset offset(const Piece& piece, NorthEast p);
    const std::vector<ShoreLine>& lines() const { return m_lines; }

    /// Calls visit(piece) for every segment that may lie within `radius_m` of p. Each segment may come more
    /// than once.
    template <typename Visit>
    void near(NorthEast p, double radius_m, Visit&& visit) const {
        if (m_rows == 0) return;
        const auto [row0, column0] = cell({p.north_m - radius_m, p.east_m - radius_m});
        const auto [row1, column1] = cell({p.north_m + radius_m, p.east_m + radius_m});
        for (std::size_t row = row0; row <= row1; ++row) {
            for (std::size_t column = column0; column <= column1; ++column) {
                for (const std::uint32_t i : m_cells[row * m_columns + column]) visit(m_pieces[i]);
            }
        }
    }
    /// Distance to the nearest shoreline, or `limit_m` when none is nearer.
    double distance_m(NorthEast p, double limit_m) const;

private:
    struct Cell {
        std::size_t row;
        std::size_t column;
    };
    Cell cell(NorthEast p) const;  ///< clamped to the index

    std::vector<ShoreLine> m_lines;
    std::vector<Piece> m_pieces;
    NorthEast m_southWest;
    std::size_t m_rows = 0;
    std::size_t m_columns = 0;
    std::vector<std::vector<std::uint32_t>> m_cells;
};

}  // namespace sagara::core
