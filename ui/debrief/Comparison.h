#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/assess/Mission.h"
#include "core/exercise/Event.h"
#include "core/exercise/Track.h"
#include "core/exercise/World.h"

namespace sagara::ui {

/// What one of two runs came to in the time they are compared.
struct RunFigures {
    double until_s = 0.0;
    double mostSpeed_mps = 0.0;
    double leastUnderKeel_m = 0.0, leastUnderKeel_s = 0.0;
    std::optional<double> closestShips_m, closestShips_s;  ///< to another ship; none within 5 km
    double closestShore_m = 0.0, closestShore_s = 0.0;     ///< 100 m: farther
    double mostOffTrack_m = 0.0, mostOffTrack_s = 0.0;     ///< magnitude; 0 without a route
    double run_m = 0.0;                                    ///< way made over the ground
    double score = 100.0;
    std::vector<std::optional<double>> tasks_s;  ///< when each was done
};
RunFigures figuresOf(const core::World& world, const std::vector<core::TrackSample>& track,
                     const std::vector<core::Event>& events, core::SimTime from);

/// How the two tracks lie to each other at the same times.
struct TrackDifference {
    double most_m = 0.0, most_s = 0.0;
    double atEnd_m = 0.0, atEnd_s = 0.0;  ///< the last moment both reach
};
TrackDifference differenceOf(const std::vector<core::TrackSample>& a,
                             const std::vector<core::TrackSample>& b);

/// A row of the table: what was sailed, what if, the difference; and the moment to go to.
struct ComparisonRow {
    QString name;
    QString sailed;
    QString whatIf;
    QString difference;
    std::optional<core::SimTime> moment;
};
std::vector<ComparisonRow> comparisonOf(const core::World& world, const RunFigures& sailed,
                                        const RunFigures& whatIf, const TrackDifference& tracks);

}  // namespace sagara::ui
