#include "core/world/Shore.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {
constexpr double kCell_m = 100.0;
}

const char* shoreKindName(ShoreKind kind) {
    switch (kind) {
        case ShoreKind::Quay:
            return "quay";
        case ShoreKind::Jetty:
            return "jetty";
        case ShoreKind::Breakwater:
            return "breakwater";
        case ShoreKind::Rock:
            return "rock";
        case ShoreKind::Beach:
            return "beach";
        case ShoreKind::Other:
            return "shore";
    }
    return "";
}

namespace {

NorthEast unit(NorthEast v) {
    const double l = length(v);
    return l > 0.0 ? (1.0 / l) * v : NorthEast{1.0, 0.0};
}

/// Whether land lies on the right hand, going along the line: most of its pieces decide, because a line of
/// the chart may touch the ring's corners.
bool landOnTheRight(const ShoreLine& line, const std::vector<std::vector<NorthEast>>& land) {
    constexpr double kProbe_m = 0.3;
    int votes = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const NorthEast along = line.points[i] - line.points[i - 1];
        const NorthEast probe = line.points[i - 1] + 0.5 * along + kProbe_m * turnedRight(unit(along));
        const bool onLand =
            std::any_of(land.begin(), land.end(), [&](const auto& ring) { return contains(ring, probe); });
        votes += onLand ? 1 : -1;
    }
    return votes > 0;
}

/// Pieces of one line with their water sides.
void addPieces(std::vector<Shore::Piece>& pieces, const ShoreLine& line, std::uint32_t index,
               bool landRight) {
    const std::size_t first = pieces.size();
    const double side = landRight ? -1.0 : 1.0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const Segment s{line.points[i - 1], line.points[i]};
        if (s.a == s.b) continue;  // a point given twice has no side
        const NorthEast toWater = side * turnedRight(unit(s.b - s.a));
        pieces.push_back({s, index, toWater, toWater, toWater});
    }
    for (std::size_t i = first + 1; i < pieces.size(); ++i) {
        const NorthEast between = unit(pieces[i - 1].toWater + pieces[i].toWater);
        pieces[i - 1].toWaterB = pieces[i].toWaterA = between;
    }
}

/// Where two lines meet, or one closes, the corner is shared as within a line. `starts`: first piece of every
/// line, and the number of pieces.
void joinLines(std::vector<Shore::Piece>& pieces, const std::vector<std::size_t>& starts) {
    constexpr double kSamePlace_m = 0.01;
    struct End {
        NorthEast place;
        NorthEast* toWater;
    };
    std::vector<End> ends;
    for (std::size_t line = 0; line + 1 < starts.size(); ++line) {
        if (starts[line] == starts[line + 1]) continue;
        Shore::Piece& first = pieces[starts[line]];
        Shore::Piece& last = pieces[starts[line + 1] - 1];
        ends.push_back({first.segment.a, &first.toWaterA});
        ends.push_back({last.segment.b, &last.toWaterB});
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (distance(ends[i].place, ends[j].place) > kSamePlace_m) continue;
            *ends[i].toWater = *ends[j].toWater = unit(*ends[i].toWater + *ends[j].toWater);
        }
    }
}

}  // namespace

Shore::Offset Shore::offset(const Piece& piece, NorthEast p) {
    const NorthEast nearest = nearestPoint(piece.segment, p);
    const NorthEast normal = nearest == piece.segment.a   ? piece.toWaterA
                             : nearest == piece.segment.b ? piece.toWaterB
                                                          : piece.toWater;
    const double far_m = distance(nearest, p);
    return {dot(p - nearest, normal) < 0.0 ? -far_m : far_m, nearest};
}

Shore::Shore(std::vector<ShoreLine> lines, const std::vector<std::vector<NorthEast>>& land)
    : m_lines(std::move(lines)) {
    NorthEast low{1e18, 1e18}, high{-1e18, -1e18};
    std::vector<std::size_t> starts{0};
    for (std::uint32_t line = 0; line < m_lines.size(); ++line) {
        for (const NorthEast p : m_lines[line].points) {
            low = {std::min(low.north_m, p.north_m), std::min(low.east_m, p.east_m)};
            high = {std::max(high.north_m, p.north_m), std::max(high.east_m, p.east_m)};
        }
        addPieces(m_pieces, m_lines[line], line, landOnTheRight(m_lines[line], land));
        starts.push_back(m_pieces.size());
    }
    joinLines(m_pieces, starts);
    if (m_pieces.empty()) return;
    m_southWest = low;
    m_rows = static_cast<std::size_t>((high.north_m - low.north_m) / kCell_m) + 1;
    m_columns = static_cast<std::size_t>((high.east_m - low.east_m) / kCell_m) + 1;
    m_cells.resize(m_rows * m_columns);
    for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
        const Segment& s = m_pieces[i].segment;
        const auto [row0, column0] =
            cell({std::min(s.a.north_m, s.b.north_m), std::min(s.a.east_m, s.b.east_m)});
        const auto [row1, column1] =
            cell({std::max(s.a.north_m, s.b.north_m), std::max(s.a.east_m, s.b.east_m)});
        for (std::size_t row = row0; row <= row1; ++row) {
            for (std::size_t column = column0; column <= column1; ++column) {
                m_cells[row * m_columns + column].push_back(i);
            }
        }
    }
}

Shore::Cell Shore::cell(NorthEast p) const {
    const auto index = [](double offset_m, std::size_t count) {
        return static_cast<std::size_t>(
            std::clamp(std::floor(offset_m / kCell_m), 0.0, static_cast<double>(count - 1)));
    };
    return {index(p.north_m - m_southWest.north_m, m_rows), index(p.east_m - m_southWest.east_m, m_columns)};
}

double Shore::distance_m(NorthEast p, double limit_m) const {
    double best_m = limit_m;
    near(p, limit_m, [&](const Piece& piece) { best_m = std::min(best_m, distanceTo(piece.segment, p)); });
    return best_m;
}

}  // namespace sagara::core
