#pragma once

#include <optional>
#include <string>

#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// What the mission asks of the graded ship next. SI and radians; bearings true.
struct Hints {
    struct Task {
        std::size_t number = 1;  ///< the first is 1
        std::size_t of = 1;
        std::string title;
    };
    struct Waypoint {
        std::size_t index = 0;
        std::string name;
        double bearing_rad = 0.0;
        double distance_m = 0.0;
        std::optional<double> time_s;  ///< at the present speed; none when she does not come nearer
    };
    struct SpeedAhead {
        double limit_mps = 0.0;
        double in_m = 0.0;  ///< along the route
    };
    struct OffTrack {
        double off_m = 0.0;    ///< to starboard positive
        double limit_m = 0.0;  ///< of the corridor on that side
        bool outside() const;
    };
    std::optional<Task> task;  ///< none without tasks, or when all are done
    bool allDone = false;
    std::optional<Waypoint> waypoint;  ///< none without a route, or past its end
    std::optional<double> speedLimit_mps;
    std::optional<SpeedAhead> ahead;  ///< the next lower limit within a mile
    std::optional<OffTrack> track;
};

/// `route`: how far along she is, as the assessment keeps it in State.
Hints hintsFor(const core::World& world, const core::Snapshot& now, const core::RouteProgress& route);
/// For who has no State: takes the nearest part of the whole route, which may be a later one where legs
/// cross.
Hints hintsFor(const core::World& world, const core::Snapshot& now);

}  // namespace sagara::ui
