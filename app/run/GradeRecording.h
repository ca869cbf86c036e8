#pragma once

#include "app/run/RunSummary.h"
#include "core/exercise/Replay.h"

namespace sagara::run {

/// Grade of a recorded run up to a tick: by running it again where this build can, else from its kinematic
/// track; the summary says which. `rubric`: another mission to grade by, or null for the run's own. `after`
/// sees every tick of a run that is run again, or null.
RunSummary gradeRecording(const core::World& world, const core::Recording& recording, std::int64_t untilTick,
                          const core::Mission* rubric = nullptr, const core::AfterTick& after = nullptr);

}  // namespace sagara::run
