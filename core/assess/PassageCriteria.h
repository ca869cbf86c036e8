#pragma once

#include "core/assess/Criterion.h"

namespace sagara::core {

/// "cross-track": off the route by more than the leg's limits, from waypoint "fromWaypoint" until an anchor
/// is let go.
std::unique_ptr<const Criterion> makeCrossTrackCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext& context);

/// "speed-limit": speed over ground above the lowest limit of the zones she is in by 0.1 kn, which the
/// display does not show. A zone is the legs up to a waypoint {"toWaypoint", "speed_kn"} or a circle {"near",
/// "within_M", "speed_kn"}.
std::unique_ptr<const Criterion> makeSpeedLimitCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext& context);

/// "time-limit": from the first line let go (or the start, without lines) to the last task; "limit_min" by
/// level, 1 to 5. Breaks once, when the time is over.
std::unique_ptr<const Criterion> makeTimeLimitCriterion(Criterion::Terms terms, config::Reader& in,
                                                        const MissionContext& context);

}  // namespace sagara::core
