#include "render/scene/land/LandMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sagara::render {
namespace {

constexpr double kCoarse_m = 80.0;
constexpr int kChunkCells = 14;  ///< coarse cells along a side of a piece
constexpr double kBelow_m = -2.5;
/// How far the ground may be from the plane drawn instead: tree tops matter less than a beach.
constexpr double kFlatShore_m = 0.3;
constexpr double kFlatInland_m = 2.5;

/// A node of either net.
struct Node {
    core::NorthEast p;
    Ground::Spot spot;
    double up = 0.0;
};

struct Box {
    core::NorthEast low{1e9, 1e9};
    core::NorthEast high{-1e9, -1e9};
};

Box boxOf(const core::Area& area) {
    Box b;
    for (const auto& ring : area.land) {
        for (const core::NorthEast& p : ring) {
            b.low = {std::min(b.low.north_m, p.north_m), std::min(b.low.east_m, p.east_m)};
            b.high = {std::max(b.high.north_m, p.north_m), std::max(b.high.east_m, p.east_m)};
        }
    }
    return b;
}

Point pointOf(const Node& n) { return {n.p.north_m, n.p.east_m, n.up}; }

class LandBuilder {
public:
    LandBuilder(const core::Area& area, const Ground& ground) : m_area(area), m_ground(ground) {}
    std::vector<Solid> build();

private:
    Node node(core::NorthEast p) const {
        Node n{p, m_ground.spot(p), 0.0};
        if (n.spot.inland_m > 0.0) n.up = m_ground.height_m(p, n.spot, true);
        return n;
    }
    /// The point of the edge where the shoreline cuts it.
    Node cut(const Node& land, const Node& sea) const;
    void cell(Solid& out, const std::array<const Node*, 4>& corners) const;
    void fine(Solid& out, core::NorthEast southWest) const;
    void add(Solid& out, const std::vector<Node>& polygon) const;
    Point normalAt(const Node& n) const;
    bool worksNear(core::NorthEast middle) const;
    const Node& coarse(int row, int column) const {
        return m_nodes[static_cast<std::size_t>(row * m_columns + column)];
    }
    bool isFine(int row, int column) const;

    const core::Area& m_area;
    const Ground& m_ground;
    int m_rows = 0;
    int m_columns = 0;
    std::vector<Node> m_nodes;
};

Node LandBuilder::cut(const Node& land, const Node& sea) const {
    const double f = land.spot.inland_m / (land.spot.inland_m - sea.spot.inland_m);
    Node n{land.p + f * (sea.p - land.p), land.spot, 0.0};
    n.spot.inland_m = 0.0;
    n.up = m_ground.height_m(n.p, n.spot, false);
    return n;
}

/// From the slope of the ground over a few metres, so that neighbouring cells agree.
Point LandBuilder::normalAt(const Node& n) const {
    const double step = n.spot.inland_m < Ground::kFar_m ? 6.0 : 40.0;
    const auto up = [&](double north, double east) {
        const core::NorthEast p = n.p + core::NorthEast{north, east};
        return m_ground.height_m(p, n.spot,
                                 true);  // the spot's distance is kept: slopes of the shore do not show
    };
    return normalised({up(-step, 0) - up(step, 0), up(0, -step) - up(0, step), 2.0 * step});
}

void LandBuilder::add(Solid& out, const std::vector<Node>& polygon) const {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    // Steep faces of works and walls get their own normal, the rest that of the ground.
    const Point flat = normalised(
        cross(pointOf(polygon[1]) - pointOf(polygon[0]), pointOf(polygon.back()) - pointOf(polygon[0])));
    const bool steep = std::abs(flat.up) < 0.75;
    for (const Node& n : polygon)
        out.vertices.push_back({pointOf(n), steep ? flat : normalAt(n), m_ground.paint(n.p, n.spot)});
    for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i)
        out.indices.insert(out.indices.end(), {first, first + i, first + i + 1});
}

void LandBuilder::cell(Solid& out, const std::array<const Node*, 4>& corners) const {
    std::vector<Node> polygon;
    std::vector<Node> cuts;
    for (std::size_t i = 0; i < 4; ++i) {
        const Node &a = *corners[i], &b = *corners[(i + 1) % 4];
        const bool aLand = a.spot.inland_m > 0.0, bLand = b.spot.inland_m > 0.0;
        if (aLand) polygon.push_back(a);
        if (aLand != bLand) {
            polygon.push_back(aLand ? cut(a, b) : cut(b, a));
            cuts.push_back(polygon.back());
        }
    }
    if (polygon.size() >= 3) add(out, polygon);
    if (cuts.size() == 2 && cuts[0].up > 0.0) {  // a quay wall
        const Paint wet = darker(m_ground.paint(cuts[0].p, cuts[0].spot), 0.7);
        Point a = pointOf(cuts[0]), b = pointOf(cuts[1]);
        Point c = b, d = a;
        c.up = d.up = kBelow_m;
        out.quad(a, b, c, d, wet);
    }
}

bool LandBuilder::worksNear(core::NorthEast middle) const {
    bool found = false;
    m_area.shore.near(middle, 0.8 * kCoarse_m, [&](const core::Shore::Piece& piece) {
        const Ground::Spot s{0.0, m_area.shore.lines()[piece.line].kind, false};
        found = found || (m_ground.works(s) &&
                          std::abs(core::Shore::offset(piece, middle).distance_m) < 0.75 * kCoarse_m);
    });
    return found;
}

void LandBuilder::fine(Solid& out, core::NorthEast southWest) const {
    const double half = 0.5 * kCoarse_m;
    const int n = worksNear(southWest + core::NorthEast{half, half}) ? 16 : 8;
    const double step = kCoarse_m / n;
    std::vector<Node> nodes;
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= n; ++column)
            nodes.push_back(node(southWest + core::NorthEast{row * step, column * step}));
    const auto at = [&](int row, int column) {
        return &nodes[static_cast<std::size_t>(row * (n + 1) + column)];
    };
    // One quad where the ground between its corners is as good as flat, or far from the shore; else its
    // quarters.
    const auto flat = [&](int row, int column, int size) {
        const Node &a = *at(row, column), &b = *at(row, column + size), &c = *at(row + size, column),
                   &d = *at(row + size, column + size);
        for (int i = 0; i <= size; ++i) {
            for (int j = 0; j <= size; ++j) {
                const Node& inner = *at(row + i, column + j);
                if (inner.spot.inland_m <= 0.0) return false;
                const double fi = static_cast<double>(i) / size, fj = static_cast<double>(j) / size;
                const double plane =
                    (1 - fi) * ((1 - fj) * a.up + fj * b.up) + fi * ((1 - fj) * c.up + fj * d.up);
                if (std::abs(inner.up - plane) > (inner.spot.inland_m > 40.0 ? kFlatInland_m : kFlatShore_m))
                    return false;
            }
        }
        return true;
    };
    const auto block = [&](const auto& self, int row, int column, int size) -> void {
        if (size == 1 || flat(row, column, size))
            return cell(out, {at(row, column), at(row + size, column), at(row + size, column + size),
                              at(row, column + size)});
        for (const int i : {0, size / 2})
            for (const int j : {0, size / 2}) self(self, row + i, column + j, size / 2);
    };
    block(block, 0, 0, n);
}

bool LandBuilder::isFine(int row, int column) const {
    if (row < 0 || column < 0 || row + 1 >= m_rows || column + 1 >= m_columns) return false;
    for (const int i : {0, 1})
        for (const int j : {0, 1})
            if (std::abs(coarse(row + i, column + j).spot.inland_m) < 0.99 * Ground::kFar_m) return true;
    return false;
}

std::vector<Solid> LandBuilder::build() {
    const Box box = boxOf(m_area);
    const core::NorthEast origin{std::floor(box.low.north_m / kCoarse_m) * kCoarse_m,
                                 std::floor(box.low.east_m / kCoarse_m) * kCoarse_m};
    m_rows = static_cast<int>((box.high.north_m - origin.north_m) / kCoarse_m) + 2;
    m_columns = static_cast<int>((box.high.east_m - origin.east_m) / kCoarse_m) + 2;
    if (m_area.land.empty()) return {};
    for (int row = 0; row < m_rows; ++row)
        for (int column = 0; column < m_columns; ++column)
            m_nodes.push_back(node(origin + core::NorthEast{row * kCoarse_m, column * kCoarse_m}));
    std::map<std::pair<int, int>, Solid> chunks;
    for (int row = 0; row + 1 < m_rows; ++row) {
        for (int column = 0; column + 1 < m_columns; ++column) {
            Solid& out = chunks[{row / kChunkCells, column / kChunkCells}];
            if (isFine(row, column)) {
                fine(out, coarse(row, column).p);
                continue;
            }
            const std::array<const Node*, 4> corners{&coarse(row, column), &coarse(row + 1, column),
                                                     &coarse(row + 1, column + 1), &coarse(row, column + 1)};
            cell(out, corners);
            // A skirt hides what does not meet where the nets change.
            const bool neighbours[] = {isFine(row, column - 1), isFine(row + 1, column),
                                       isFine(row, column + 1), isFine(row - 1, column)};
            for (std::size_t i = 0; i < 4; ++i) {
                const Node &a = *corners[i], &b = *corners[(i + 1) % 4];
                if (!neighbours[i] || a.spot.inland_m <= 0.0 || b.spot.inland_m <= 0.0) continue;
                Point low1 = pointOf(b), low2 = pointOf(a);
                low1.up -= 15.0;
                low2.up -= 15.0;
                out.quad(pointOf(a), pointOf(b), low1, low2, m_ground.paint(a.p, a.spot));
            }
        }
    }
    std::vector<Solid> solids;
    for (auto& [key, solid] : chunks)
        if (!solid.indices.empty()) solids.push_back(std::move(solid));
    return solids;
}

}  // namespace

std::vector<Solid> landMesh(const core::Area& area, const Ground& ground) {
    return LandBuilder(area, ground).build();
}

Solid distantCoast(const core::Area& area) {
    constexpr Paint kShore{0.55, 0.50, 0.38}, kTrees{0.12, 0.22, 0.09};
    constexpr double kStep_m = 250.0;
    const Box box = boxOf(area);
    const auto detailed = [&](core::NorthEast p) {
        return p.north_m > box.low.north_m && p.north_m < box.high.north_m && p.east_m > box.low.east_m &&
               p.east_m < box.high.east_m;
    };
    Solid out;
    for (const auto& ring : area.context) {
        std::vector<core::NorthEast> points;
        for (const core::NorthEast& p : ring)
            if (points.empty() || core::distance(points.back(), p) > kStep_m) points.push_back(p);
        if (points.size() < 3) continue;
        const auto inland = [&](std::size_t i, double away_m, double up) {  // the land is on the right hand
            const core::NorthEast along =
                points[(i + 1) % points.size()] - points[(i + points.size() - 1) % points.size()];
            const double size = std::max(1.0, core::length(along));
            const core::NorthEast p = points[i] + (away_m / size) * core::turnedRight(along);
            return Point{p.north_m, p.east_m, up + (up > 5.0 ? 6.0 * placeNoise(p, 400.0) : 0.0)};
        };
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t j = (i + 1) % points.size();
            if (detailed(points[i]) || core::distance(points[i], points[j]) > 4.0 * kStep_m) continue;
            out.quad(inland(i, 0, -0.5), inland(j, 0, -0.5), inland(j, 40, 2.0), inland(i, 40, 2.0), kShore);
            out.quad(inland(i, 40, 2.0), inland(j, 40, 2.0), inland(j, 70, 12.0), inland(i, 70, 12.0),
                     kTrees);
            out.quad(inland(i, 70, 12.0), inland(j, 70, 12.0), inland(j, 900, 26.0), inland(i, 900, 26.0),
                     kTrees);
        }
    }
    return out;
}

}  // namespace sagara::render
