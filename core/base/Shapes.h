#pragma once

#include <span>
#include <vector>

#include "core/base/Planar.h"

/// Plane geometry of polygons and segments in frame N.
namespace sagara::core {

struct Segment {
    NorthEast a;
    NorthEast b;
};

/// The point of the segment nearest to p; beyond an end exactly that end.
NorthEast nearestPoint(const Segment& s, NorthEast p);
double distanceTo(const Segment& s, NorthEast p);

/// Whether going from `from` to `to` passes through the segment; touching an end counts once.
bool crosses(const Segment& s, NorthEast from, NorthEast to);

/// Closed ring, first point not repeated, either sense. A point on the border may count as either.
bool contains(std::span<const NorthEast> ring, NorthEast p);

/// Positive for a ring that runs clockwise seen from above (north up, east right).
double clockwiseArea_m2(std::span<const NorthEast> ring);

}  // namespace sagara::core
