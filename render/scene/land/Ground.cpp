#include "render/scene/land/Ground.h"

#include <algorithm>
#include <cmath>

namespace sagara::render {
namespace {

constexpr Paint kSand{0.74, 0.67, 0.50};
constexpr Paint kConcrete{0.56, 0.55, 0.52};
constexpr Paint kRubble{0.40, 0.38, 0.35};
constexpr Paint kRock{0.37, 0.32, 0.26};
constexpr Paint kWall{0.40, 0.37, 0.33};
constexpr Paint kTreesDark{0.085, 0.175, 0.065};
constexpr Paint kTreesLight{0.20, 0.31, 0.11};
constexpr Paint kTown{0.40, 0.37, 0.29};

double ramp(double from, double to, double v) {
    const double t = std::clamp((v - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double hash(int i, int j) {
    auto h = static_cast<std::uint32_t>(i) * 0x9e3779b1u ^ static_cast<std::uint32_t>(j) * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return static_cast<double>((h ^ (h >> 15)) & 0xffffu) / 65535.0;
}

}  // namespace

double placeNoise(core::NorthEast p, double size_m) {
    const double u = p.north_m / size_m, v = p.east_m / size_m;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    const double fu = ramp(0.0, 1.0, u - i), fv = ramp(0.0, 1.0, v - j);
    return (1 - fu) * ((1 - fv) * hash(i, j) + fv * hash(i, j + 1)) +
           fu * ((1 - fv) * hash(i + 1, j) + fv * hash(i + 1, j + 1));
}

Ground::Ground(const core::Area& area) : m_area(area) {
    if (const core::Place* fort = area.findPlace("fort")) m_fort = fort->position;
    for (const auto& ring : area.land) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            core::NorthEast a = ring[i], b = ring[(i + 1) % ring.size()];
            if (a.north_m > b.north_m) std::swap(a, b);
            const int first = static_cast<int>(std::ceil(a.north_m / kRow_m));
            for (int row = first; row * kRow_m < b.north_m; ++row) {
                const double f = (row * kRow_m - a.north_m) / (b.north_m - a.north_m);
                m_rows[row].push_back(a.east_m + f * (b.east_m - a.east_m));
            }
        }
    }
    for (auto& [row, crossings] : m_rows) std::sort(crossings.begin(), crossings.end());
}

bool Ground::inside(core::NorthEast p) const {
    const auto row = m_rows.find(static_cast<int>(std::lround(p.north_m / kRow_m)));
    if (row == m_rows.end()) return false;
    const auto& c = row->second;
    return (std::lower_bound(c.begin(), c.end(), p.east_m) - c.begin()) % 2 == 1;
}

Ground::Spot Ground::spot(core::NorthEast p) const {
    Spot s;
    double nearest_m = kFar_m;
    bool water = true, known = false;
    m_area.shore.near(p, kFar_m, [&](const core::Shore::Piece& piece) {
        const core::Shore::Offset offset = core::Shore::offset(piece, p);
        const double away_m = std::abs(offset.distance_m);
        if (away_m >= nearest_m) return;
        nearest_m = away_m;
        water = offset.distance_m > 0.0;
        known = true;
        const core::ShoreLine& line = m_area.shore.lines()[piece.line];
        s.kind = line.kind;
        s.fort = line.name.find("Fort") != std::string::npos;
    });
    if (!known) water = !inside(p);
    s.inland_m = water ? -nearest_m : nearest_m;
    return s;
}

bool Ground::works(const Spot& s) const {
    return s.kind == core::ShoreKind::Quay || s.kind == core::ShoreKind::Jetty ||
           s.kind == core::ShoreKind::Breakwater;
}

double Ground::trees_m(core::NorthEast p, const Spot& s) const {
    const double yard = works(s) ? ramp(48.0, 80.0, s.inland_m) : 1.0;
    const double town = ramp(520.0, 380.0, core::distance(p, m_fort));
    const double grown = yard * ramp(22.0, 55.0, s.inland_m) * (1.0 - 0.9 * town);
    return grown * (4.0 + 7.0 * placeNoise(p, 45.0) + 4.0 * placeNoise(p, 17.0));
}

double Ground::height_m(core::NorthEast p, const Spot& s, bool trees) const {
    const double d = s.inland_m;
    double shore_m = 0.0;
    switch (s.kind) {
        case core::ShoreKind::Quay:
        case core::ShoreKind::Jetty:
            shore_m = 1.9;
            break;
        case core::ShoreKind::Breakwater:
            shore_m = std::min(3.4, -0.4 + 0.75 * d);
            break;
        case core::ShoreKind::Rock:
            shore_m =
                s.fort ? -0.4 + 1.6 * ramp(0.0, 4.0, d) + 7.5 * ramp(5.0, 7.0, d) - 3.0 * ramp(14.0, 24.0, d)
                       : -0.4 + 5.0 * ramp(0.0, 14.0, d);
            break;
        case core::ShoreKind::Beach:
            shore_m = -0.4 + 2.6 * ramp(0.0, 30.0, d);
            break;
        case core::ShoreKind::Other:
            shore_m = -0.4 + 2.4 * ramp(0.0, 10.0, d);
            break;
    }
    double elevation_m = 0.0;
    for (const core::Grid& grid : m_area.elevation) {
        if (!grid.covers(p)) continue;
        elevation_m = grid.at(p);
        break;
    }
    if (m_area.elevation.empty() || !m_area.elevation.back().covers(p)) elevation_m = 8.0;
    const double hill_m = ramp(25.0, 110.0, d) * std::max(0.0, elevation_m - 2.0) * (works(s) ? 0.3 : 1.0);
    return shore_m + hill_m + (trees ? trees_m(p, s) : 0.0);
}

Paint Ground::paint(core::NorthEast p, const Spot& s) const {
    const Paint trees =
        mixed(kTreesDark, kTreesLight, 0.65 * placeNoise(p, 60.0) + 0.35 * placeNoise(p, 13.0));
    const double speckle = 0.88 + 0.24 * placeNoise(p, 7.0);
    const double town = ramp(520.0, 380.0, core::distance(p, m_fort));
    const Paint inland = mixed(trees, mixed(kTown, trees, 0.45 * placeNoise(p, 30.0)), town);
    switch (s.kind) {
        case core::ShoreKind::Quay:
        case core::ShoreKind::Jetty:
            return mixed(darker(kConcrete, speckle), inland, ramp(42.0, 60.0, s.inland_m));
        case core::ShoreKind::Breakwater:
            return mixed(darker(kRubble, speckle), inland, ramp(25.0, 40.0, s.inland_m));
        case core::ShoreKind::Rock:
            return s.fort ? mixed(darker(kWall, speckle), inland, ramp(12.0, 16.0, s.inland_m))
                          : mixed(darker(kRock, speckle), inland, ramp(10.0, 22.0, s.inland_m));
        case core::ShoreKind::Beach:
            return mixed(darker(kSand, speckle), inland, ramp(22.0, 38.0, s.inland_m));
        case core::ShoreKind::Other:
            return mixed(mixed(kRock, kSand, placeNoise(p, 120.0)), inland, ramp(6.0, 16.0, s.inland_m));
    }
    return inland;
}

}  // namespace sagara::render
