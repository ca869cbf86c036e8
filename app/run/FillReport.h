#pragma once

#include "app/run/RunSummary.h"
#include "core/exercise/Recording.h"
#include "ui/report/ReportData.h"

namespace sagara::run {

/// Everything the report of a recorded run shows, graded by `mission` (the world's own, or another).
report::RunReport fillReport(const core::World& world, const core::Mission& mission,
                             const core::Recording& recording, const RunSummary& summary);

}  // namespace sagara::run
