#include "core/base/Shapes.h"

#include <algorithm>

namespace sagara::core {

NorthEast nearestPoint(const Segment& s, NorthEast p) {
    const NorthEast along = s.b - s.a;
    const double squared_m2 = dot(along, along);
    const double fraction = squared_m2 == 0.0 ? 0.0 : dot(p - s.a, along) / squared_m2;
    if (fraction <= 0.0) return s.a;
    if (fraction >= 1.0) return s.b;  // exactly: a + 1 (b - a) may be another number
    return s.a + fraction * along;
}

double distanceTo(const Segment& s, NorthEast p) { return distance(nearestPoint(s, p), p); }

bool crosses(const Segment& s, NorthEast from, NorthEast to) {
    const NorthEast gate = s.b - s.a, way = to - from;
    const double before = cross(gate, from - s.a), after = cross(gate, to - s.a);
    const double left = cross(way, s.a - from), right = cross(way, s.b - from);
    return (before < 0.0) != (after < 0.0) && (left < 0.0) != (right < 0.0);
}

bool contains(std::span<const NorthEast> ring, NorthEast p) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const NorthEast a = ring[i], b = ring[j];
        if ((a.north_m > p.north_m) == (b.north_m > p.north_m)) continue;
        const double east_m =
            a.east_m + (b.east_m - a.east_m) * (p.north_m - a.north_m) / (b.north_m - a.north_m);
        if (p.east_m < east_m) inside = !inside;
    }
    return inside;
}

double clockwiseArea_m2(std::span<const NorthEast> ring) {
    double twice_m2 = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        twice_m2 += cross(ring[j], ring[i]);
    return 0.5 * twice_m2;
}

}  // namespace sagara::core
