#pragma once

#include "app/tools/ReferenceTable.h"
#include "core/identify/Trial.h"
#include "ui/report/XyPlot.h"

namespace sagara::tools {

/// The track of a trial, or heading and rudder over time, with a published trace (columns t, x, y, psi) where
/// there is one.
report::XyPlot trialPlot(const std::string& ship, const core::Trial& trial, bool overTime,
                         const ReferenceTable* published);

}  // namespace sagara::tools
