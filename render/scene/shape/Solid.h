#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sagara::render {

/// A point of a shape: x ahead (or north), y to starboard (or east), height above the waterline (or datum).
struct Point {
    double x = 0.0;
    double y = 0.0;
    double up = 0.0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.up + b.up}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.up - b.up}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y, s * a.up}; }
inline Point cross(Point a, Point b) {
    return {a.y * b.up - a.up * b.y, a.up * b.x - a.x * b.up, a.x * b.y - a.y * b.x};
}
Point normalised(Point a);

/// Of a surface in white light, as the screen gets it. `glow`: share of light it gives by itself at night.
struct Paint {
    double red = 0.5;
    double green = 0.5;
    double blue = 0.5;
    double glow = 0.0;

    std::uint32_t abgr() const;  ///< red in the lowest byte, 1 - glow in the highest
};
Paint mixed(Paint a, Paint b, double f);
Paint darker(Paint a, double f);

struct SolidVertex {
    Point position;
    Point normal;
    Paint colour;
};

/// A shape of coloured triangles. Triangles may wind either way: the shader turns normals towards the eye.
struct Solid {
    std::vector<SolidVertex> vertices;
    std::vector<std::uint32_t> indices;

    void triangle(Point a, Point b, Point c, Paint paint);
    void quad(Point a, Point b, Point c, Point d, Paint paint);
    /// Upright box about a centre: half lengths; `turn_rad` clockwise from above; bottom is left out.
    void box(Point bottomCentre, double halfX, double halfY, double height, Paint paint,
             double turn_rad = 0.0);
    /// A box whose top is smaller or shifted: offsets of the top's four corners' half lengths.
    void tapered(Point bottomCentre, double halfX, double halfY, Point topCentre, double topHalfX,
                 double topHalfY, Paint paint);
    /// Round, about an axis that stands upright; radii at heights, closed on top.
    struct Ring {
        double up;
        double radius;
        Paint paint;  ///< of what is above this ring
    };
    void turned(Point base, std::span<const Ring> rings, int sides);
    /// A straight round bar.
    void bar(Point a, Point b, double radius, Paint paint, int sides = 5);
    /// A smooth surface through rows of points, each row as long as the others.
    void surface(const std::vector<std::vector<Point>>& rows, const std::vector<std::vector<Paint>>& paints);
    void append(const Solid& other, Point offset, double turn_rad = 0.0, double scale = 1.0);
    std::size_t triangles() const { return indices.size() / 3; }
};

}  // namespace sagara::render
