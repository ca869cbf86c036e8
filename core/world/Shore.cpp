#include "core/world/Shore.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {
constexpr double kCell_m = 100.0;
}

const char* shoreKindName(ShoreKind kind) {
    switch (kind) {
        case ShoreKind::Quay: return "quay";
        case ShoreKind::Jetty: return "jetty";
        case ShoreKind::Breakwater: return "breakwater";
        case ShoreKind::Rock: return "rock";
        case ShoreKind::Beach: return "beach";
        case ShoreKind::Other: return "shore";
    }
    return "";
}

Shore::Shore(std::vector<ShoreLine> lines) : m_lines(std::move(lines)) {
    NorthEast low{1e18, 1e18}, high{-1e18, -1e18};
    for (std::uint32_t line = 0; line < m_lines.size(); ++line) {
        const std::vector<NorthEast>& points = m_lines[line].points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            low = {std::min(low.north_m, points[i].north_m), std::min(low.east_m, points[i].east_m)};
            high = {std::max(high.north_m, points[i].north_m), std::max(high.east_m, points[i].east_m)};
            if (i > 0) m_pieces.push_back({{points[i - 1], points[i]}, line});
        }
    }
    if (m_pieces.empty()) return;
    m_southWest = low;
    m_rows = static_cast<std::size_t>((high.north_m - low.north_m) / kCell_m) + 1;
    m_columns = static_cast<std::size_t>((high.east_m - low.east_m) / kCell_m) + 1;
    m_cells.resize(m_rows * m_columns);
    for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
        const Segment& s = m_pieces[i].segment;
        const auto [row0, column0] = cell({std::min(s.a.north_m, s.b.north_m), std::min(s.a.east_m, s.b.east_m)});
        const auto [row1, column1] = cell({std::max(s.a.north_m, s.b.north_m), std::max(s.a.east_m, s.b.east_m)});
        for (std::size_t row = row0; row <= row1; ++row) {
            for (std::size_t column = column0; column <= column1; ++column) {
                m_cells[row * m_columns + column].push_back(i);
            }
        }
    }
}

Shore::Cell Shore::cell(NorthEast p) const {
    const auto index = [](double offset_m, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(std::floor(offset_m / kCell_m), 0.0, static_cast<double>(count - 1)));
    };
    return {index(p.north_m - m_southWest.north_m, m_rows), index(p.east_m - m_southWest.east_m, m_columns)};
}

double Shore::distance_m(NorthEast p, double limit_m) const {
    double best_m = limit_m;
    near(p, limit_m, [&](const Piece& piece) { best_m = std::min(best_m, distanceTo(piece.segment, p)); });
    return best_m;
}

}  // namespace sagara::core
