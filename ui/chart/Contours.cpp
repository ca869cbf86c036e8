#include "ui/chart/Contours.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "ui/chart/Polyline.h"

namespace sagara::chart {
namespace {

using core::NorthEast;
using Line = std::vector<NorthEast>;

constexpr double kLight = 0.05;  ///< of the spacing: far below what a chart shows
constexpr std::uint32_t kNone = 0xffffffff;

/// Crossings of one value with the edges of a grid, and which of them belong together. An edge has one
/// crossing at most and lies in two cells at most, so each crossing has two neighbours at most: the crossings
/// are chains and rings.
class Tracer {
public:
    Tracer(const core::Grid& grid, double value)
        : m_grid(grid), m_value(value), m_links(2 * grid.rows() * grid.columns(), Links{kNone, kNone}) {}

    void addCell(std::size_t row, std::size_t column);
    std::vector<Line> lines();

private:
    using Links = std::array<std::uint32_t, 2>;

    double value(std::size_t node) const { return static_cast<double>(m_grid.values()[node]); }
    bool deep(std::size_t node) const { return value(node) >= m_value; }
    /// Edge from a node to its eastern neighbour, and to its northern one.
    static std::size_t eastEdge(std::size_t node) { return 2 * node; }
    static std::size_t northEdge(std::size_t node) { return 2 * node + 1; }
    void link(std::size_t a, std::size_t b);
    void linkSaddle(const std::array<std::size_t, 4>& edges, bool southWestDeep, double centre);
    NorthEast crossing(std::size_t edge) const;
    Line follow(std::size_t edge);

    const core::Grid& m_grid;
    double m_value;
    std::vector<Links> m_links;
};

void Tracer::link(std::size_t a, std::size_t b) {
    m_links[a][m_links[a][0] == kNone ? 0 : 1] = static_cast<std::uint32_t>(b);
    m_links[b][m_links[b][0] == kNone ? 0 : 1] = static_cast<std::uint32_t>(a);
}

/// All four edges crossed: the mean of the corners says which corners hang together.
void Tracer::linkSaddle(const std::array<std::size_t, 4>& e, bool southWestDeep, double centre) {
    const auto [south, east, north, west] = e;
    if ((centre >= m_value) == southWestDeep) {
        link(south, east);
        link(north, west);
    } else {
        link(south, west);
        link(north, east);
    }
}

void Tracer::addCell(std::size_t row, std::size_t column) {
    const std::size_t sw = row * m_grid.columns() + column, se = sw + 1;
    const std::size_t nw = sw + m_grid.columns(), ne = nw + 1;
    const std::array<bool, 4> crossed{deep(sw) != deep(se), deep(se) != deep(ne), deep(nw) != deep(ne),
                                      deep(sw) != deep(nw)};
    const std::array<std::size_t, 4> edges{eastEdge(sw), northEdge(se), eastEdge(nw), northEdge(sw)};
    std::size_t count = 0;
    std::array<std::size_t, 4> found{};
    for (std::size_t i = 0; i < 4; ++i) {
        if (crossed[i]) found[count++] = edges[i];
    }
    if (count == 2) link(found[0], found[1]);
    if (count == 4) linkSaddle(edges, deep(sw), 0.25 * (value(sw) + value(se) + value(nw) + value(ne)));
}

NorthEast Tracer::crossing(std::size_t edge) const {
    const std::size_t from = edge / 2, to = edge % 2 == 0 ? from + 1 : from + m_grid.columns();
    const double fraction = (m_value - value(from)) / (value(to) - value(from));
    const NorthEast a = m_grid.node(from / m_grid.columns(), from % m_grid.columns());
    const NorthEast b = m_grid.node(to / m_grid.columns(), to % m_grid.columns());
    return a + fraction * (b - a);
}

/// The chain or ring through an edge, from that edge on; what was followed is taken out.
Line Tracer::follow(std::size_t edge) {
    Line line;
    std::size_t before = kNone, now = edge;
    while (true) {
        const NorthEast p = crossing(now);
        // where the value lies on a node the crossings of its edges fall together
        if (line.empty() || core::distance(line.back(), p) > 1e-6 * m_grid.spacing_m()) line.push_back(p);
        const Links next = m_links[now];
        m_links[now] = {kNone, kNone};
        const std::uint32_t ahead = next[0] == before ? next[1] : next[0];
        before = now;
        if (ahead == kNone) return line;
        now = ahead;
        if (now == edge) break;
    }
    if (core::distance(line.back(), line.front()) <= 1e-6 * m_grid.spacing_m()) line.pop_back();
    line.push_back(line.front());
    return line;
}

/// A ring so small that simplifying left no area, or a chain that left no length, is no line any more.
bool hasExtent(const Line& line) { return line.size() > (line.front() == line.back() ? 3 : 1); }

std::vector<Line> Tracer::lines() {
    std::vector<Line> all;
    for (const bool chains : {true, false}) {  // chains from their ends first; what is left are rings
        for (std::size_t edge = 0; edge < m_links.size(); ++edge) {
            if (m_links[edge][0] == kNone || (chains && m_links[edge][1] != kNone)) continue;
            const Line line = simplified(follow(edge), kLight * m_grid.spacing_m());
            if (hasExtent(line)) all.push_back(line);
        }
    }
    return all;
}

/// The grid in a frame of ground so high that every line closes within a hair of the grid's own edge.
core::Grid framed(const core::Grid& grid) {
    constexpr float kHigh = -1e6f;
    const std::size_t columns = grid.columns() + 2;
    std::vector<float> values(columns * (grid.rows() + 2), kHigh);
    for (std::size_t row = 0; row < grid.rows(); ++row) {
        const auto from = grid.values().begin() + static_cast<std::ptrdiff_t>(row * grid.columns());
        std::copy(from, from + static_cast<std::ptrdiff_t>(grid.columns()),
                  values.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns + 1));
    }
    const NorthEast corner = grid.southWest() - NorthEast{grid.spacing_m(), grid.spacing_m()};
    return {corner, grid.spacing_m(), grid.rows() + 2, columns, std::move(values)};
}

}  // namespace

std::vector<Line> contourLines(const core::Grid& grid, double value,
                               const std::function<bool(NorthEast)>& skip) {
    Tracer tracer(grid, value);
    const NorthEast half{0.5 * grid.spacing_m(), 0.5 * grid.spacing_m()};
    for (std::size_t row = 0; row + 1 < grid.rows(); ++row) {
        for (std::size_t column = 0; column + 1 < grid.columns(); ++column) {
            if (!skip || !skip(grid.node(row, column) + half)) tracer.addCell(row, column);
        }
    }
    return tracer.lines();
}

std::vector<Contour> contoursOf(const core::Area& area, std::span<const double> depths_m) {
    std::vector<Contour> contours;
    for (const double depth_m : depths_m) {
        Contour contour{depth_m, {}};
        for (std::size_t i = 0; i < area.depths.size(); ++i) {
            const auto inFiner = [&](NorthEast p) {
                for (std::size_t finer = 0; finer < i; ++finer) {
                    if (area.depths[finer].covers(p)) return true;
                }
                return false;
            };
            for (Line& line : contourLines(area.depths[i], depth_m, inFiner)) {
                contour.lines.push_back(std::move(line));
            }
        }
        if (!contour.lines.empty()) contours.push_back(std::move(contour));
    }
    return contours;
}

std::vector<Line> deeperThan(const core::Grid& grid, double value) {
    return contourLines(framed(grid), value);
}

}  // namespace sagara::chart
