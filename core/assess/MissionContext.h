#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/Config.h"
#include "core/world/Area.h"
#include "core/world/Route.h"
#include "core/world/SpeedZone.h"

namespace sagara::core {

inline constexpr int kLevels = 5;

/// What tasks and criteria can name: places and routes of the exercise, lines of the graded ship.
struct MissionContext {
    const Area& area;
    const Route& route;     ///< may have no waypoints
    const RoutePath& path;  ///< of the route
    std::vector<std::string> lineIds;

    /// Bit mask of the lines named in a list.
    std::uint8_t readLines(config::Reader& in, const char* key) const;
    /// A place of the area by its id, or a position {"lat", "lon"}.
    NorthEast readPlace(config::Reader& in, const char* key) const;
    /// Number of a waypoint, 1 for the first, as an index.
    std::size_t readWaypoint(config::Reader& in, const char* key) const;
    /// A list of {"toWaypoint", "speed_kn"} or {"near", "within_M", "speed_kn"}.
    std::vector<SpeedZone> readSpeedZones(config::Reader& in, const char* key) const;
};

/// How far along the route the graded ship is.
struct RouteProgress {
    double along_m = 0.0;
    double offTrack_m = 0.0;  ///< to starboard positive
    std::uint32_t leg = 1;    ///< index of the waypoint the leg ends at

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.along_m, self.offTrack_m, self.leg);
    }
};

}  // namespace sagara::core
