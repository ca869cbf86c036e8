#pragma once

#include <vector>

#include "core/base/Planar.h"

namespace sagara::core {

/// A part of a passage with a speed of its own: the legs of a route up to a waypoint, or a circle.
struct SpeedZone {
    double speed_mps = 0.0;
    bool circle = false;
    std::size_t toWaypoint = 0;  ///< legs that end at this waypoint (index) or before
    NorthEast centre;
    double radius_m = 0.0;

    bool holds(NorthEast p, std::size_t leg) const {
        return circle ? distance(p, centre) <= radius_m : leg <= toWaypoint;
    }
};

/// The lowest speed of the zones that hold, or `otherwise` where none does.
inline double lowestSpeed_mps(const std::vector<SpeedZone>& zones, NorthEast p, std::size_t leg,
                              double otherwise_mps) {
    double lowest_mps = otherwise_mps;
    for (const SpeedZone& zone : zones) {
        if (zone.holds(p, leg) && zone.speed_mps < lowest_mps) lowest_mps = zone.speed_mps;
    }
    return lowest_mps;
}

}  // namespace sagara::core
