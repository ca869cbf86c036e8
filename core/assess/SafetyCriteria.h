#pragma once

#include "core/assess/Criterion.h"

namespace sagara::core {

/// "under-keel": clearance under the keel less than "limit_m".
std::unique_ptr<const Criterion> makeUnderKeelCriterion(Criterion::Terms terms, config::Reader& in,
                                                        const MissionContext& context);

/// "passing-distance": another hull (hostile craft are not counted) nearer than "limit_m", on the legs from
/// "fromWaypoint" (default 1) to "toWaypoint" (default the last).
std::unique_ptr<const Criterion> makePassingDistanceCriterion(Criterion::Terms terms, config::Reader& in,
                                                              const MissionContext& context);

}  // namespace sagara::core
