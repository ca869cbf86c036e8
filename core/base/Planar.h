#pragma once

#include <cmath>

/// Points and vectors in the horizontal plane. Two types, so that a ship-fixed lever is never added to a
/// place.
namespace sagara::core {

/// Frame N (origin at the area's datum) or a displacement in it.
struct NorthEast {
    double north_m = 0.0;
    double east_m = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.north_m, self.east_m);
    }
    friend bool operator==(const NorthEast&, const NorthEast&) = default;
};

/// Frame B: x forward of midship, y to starboard of the centreline.
struct BodyPoint {
    double x_m = 0.0;
    double y_m = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.x_m, self.y_m);
    }
    friend bool operator==(const BodyPoint&, const BodyPoint&) = default;
};

inline NorthEast operator+(NorthEast a, NorthEast b) { return {a.north_m + b.north_m, a.east_m + b.east_m}; }
inline NorthEast operator-(NorthEast a, NorthEast b) { return {a.north_m - b.north_m, a.east_m - b.east_m}; }
inline NorthEast operator*(double s, NorthEast a) { return {s * a.north_m, s * a.east_m}; }

inline double dot(NorthEast a, NorthEast b) { return a.north_m * b.north_m + a.east_m * b.east_m; }
/// Positive when b lies clockwise (to starboard) of a.
inline double cross(NorthEast a, NorthEast b) { return a.north_m * b.east_m - a.east_m * b.north_m; }
/// By the square root: std::hypot guards against overflow that metres never reach, and is ten times slower.
inline double length(NorthEast a) { return std::sqrt(dot(a, a)); }
inline double distance(NorthEast a, NorthEast b) { return length(b - a); }
/// Clockwise from true north; 0 for a zero vector.
inline double bearing_rad(NorthEast from, NorthEast to) {
    return std::atan2(to.east_m - from.east_m, to.north_m - from.north_m);
}
inline NorthEast unitVector(double bearing_rad) { return {std::cos(bearing_rad), std::sin(bearing_rad)}; }
/// The vector turned a quarter turn clockwise.
inline NorthEast turnedRight(NorthEast a) { return {-a.east_m, a.north_m}; }

/// Turns coordinates between B and N. Made once per pose because the sine and cosine are shared.
class HeadingFrame {
public:
    HeadingFrame(NorthEast origin, double heading_rad)
        : m_origin(origin), m_cos(std::cos(heading_rad)), m_sin(std::sin(heading_rad)) {}

    NorthEast point(BodyPoint p) const { return m_origin + vector(p); }
    NorthEast vector(BodyPoint p) const {
        return {m_cos * p.x_m - m_sin * p.y_m, m_sin * p.x_m + m_cos * p.y_m};
    }
    BodyPoint pointInBody(NorthEast p) const { return vectorInBody(p - m_origin); }
    BodyPoint vectorInBody(NorthEast v) const {
        return {m_cos * v.north_m + m_sin * v.east_m, -m_sin * v.north_m + m_cos * v.east_m};
    }

private:
    NorthEast m_origin;
    double m_cos;
    double m_sin;
};

}  // namespace sagara::core
