#include "render/scene/shape/Solid.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

std::uint32_t byteOf(double value) {
    return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

Point normalised(Point a) {
    const double length = std::sqrt(a.x * a.x + a.y * a.y + a.up * a.up);
    return length > 0.0 ? (1.0 / length) * a : Point{0.0, 0.0, 1.0};
}

std::uint32_t Paint::abgr() const {
    return byteOf(red) | byteOf(green) << 8 | byteOf(blue) << 16 | byteOf(1.0 - glow) << 24;
}
Paint mixed(Paint a, Paint b, double f) {
    return {a.red + (b.red - a.red) * f, a.green + (b.green - a.green) * f, a.blue + (b.blue - a.blue) * f,
            a.glow + (b.glow - a.glow) * f};
}
Paint darker(Paint a, double f) { return {a.red * f, a.green * f, a.blue * f, a.glow}; }

void Solid::triangle(Point a, Point b, Point c, Paint paint) {
    const Point n = normalised(cross(b - a, c - a));
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Point& p : {a, b, c}) vertices.push_back({p, n, paint});
    indices.insert(indices.end(), {first, first + 1, first + 2});
}

void Solid::quad(Point a, Point b, Point c, Point d, Paint paint) {
    const Point n = normalised(cross(c - a, d - b));
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Point& p : {a, b, c, d}) vertices.push_back({p, n, paint});
    indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

void Solid::tapered(Point bottom, double halfX, double halfY, Point top, double topHalfX, double topHalfY,
                    Paint paint) {
    const std::array<std::array<double, 2>, 4> corners{{{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}};
    std::array<Point, 4> low, high;
    for (std::size_t i = 0; i < 4; ++i) {
        low[i] = bottom + Point{corners[i][0] * halfX, corners[i][1] * halfY, 0.0};
        high[i] = top + Point{corners[i][0] * topHalfX, corners[i][1] * topHalfY, 0.0};
    }
    for (std::size_t i = 0; i < 4; ++i) quad(low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i], paint);
    quad(high[0], high[1], high[2], high[3], darker(paint, 0.95));
}

void Solid::box(Point bottom, double halfX, double halfY, double height, Paint paint, double turn_rad) {
    Solid upright;
    upright.tapered({}, halfX, halfY, {0.0, 0.0, height}, halfX, halfY, paint);
    append(upright, bottom, turn_rad);
}

void Solid::turned(Point base, std::span<const Ring> rings, int sides) {
    const auto at = [&](const Ring& ring, int side) {
        const double a = core::kTwoPi * side / sides;
        return base + Point{ring.radius * std::cos(a), ring.radius * std::sin(a), ring.up};
    };
    for (std::size_t n = 0; n + 1 < rings.size(); ++n) {
        for (int s = 0; s < sides; ++s)
            quad(at(rings[n], s), at(rings[n], s + 1), at(rings[n + 1], s + 1), at(rings[n + 1], s),
                 rings[n].paint);
    }
    const Ring& top = rings.back();
    for (int s = 0; s < sides && top.radius > 0.0; ++s)
        triangle(at(top, s), at(top, s + 1), base + Point{0.0, 0.0, top.up}, top.paint);
}

void Solid::bar(Point a, Point b, double radius, Paint paint, int sides) {
    const Point axis = normalised(b - a);
    const Point u = normalised(cross(axis, std::abs(axis.up) < 0.9 ? Point{0, 0, 1} : Point{1, 0, 0}));
    const Point v = cross(axis, u);
    const auto out = [&](int side) {
        const double angle = core::kTwoPi * side / sides;
        return (radius * std::cos(angle)) * u + (radius * std::sin(angle)) * v;
    };
    for (int s = 0; s < sides; ++s) quad(a + out(s), a + out(s + 1), b + out(s + 1), b + out(s), paint);
}

void Solid::surface(const std::vector<std::vector<Point>>& rows,
                    const std::vector<std::vector<Paint>>& paints) {
    const std::size_t width = rows.front().size();
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < width; ++c) {
            const Point along = rows[std::min(r + 1, rows.size() - 1)][c] - rows[r > 0 ? r - 1 : 0][c];
            const Point across = rows[r][std::min(c + 1, width - 1)] - rows[r][c > 0 ? c - 1 : 0];
            vertices.push_back({rows[r][c], normalised(cross(along, across)), paints[r][c]});
        }
    }
    const auto w = static_cast<std::uint32_t>(width);
    for (std::uint32_t r = 0; r + 1 < rows.size(); ++r) {
        for (std::uint32_t c = 0; c + 1 < w; ++c) {
            const std::uint32_t i = first + r * w + c;
            indices.insert(indices.end(), {i, i + 1, i + w + 1, i, i + w + 1, i + w});
        }
    }
}

void Solid::append(const Solid& other, Point offset, double turn_rad, double scale) {
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    const auto turned = [&](Point p) { return Point{c * p.x - s * p.y, s * p.x + c * p.y, p.up}; };
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const SolidVertex& v : other.vertices)
        vertices.push_back({offset + scale * turned(v.position), turned(v.normal), v.colour});
    for (const std::uint32_t i : other.indices) indices.push_back(first + i);
}

}  // namespace sagara::render
