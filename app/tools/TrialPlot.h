#pragma once

#include "app/tools/ReferenceTable.h"
#include "core/identify/Trial.h"
#include "ui/report/XyPlot.h"

namespace sagara::tools {

enum class TrialPicture {
    Track,
    HeadingOverTime,  ///< and the rudder
    SpeedOverReach    ///< of a ship that stops on a straight course
};

/// With a published trace (columns t, x, y, psi) where there is one; none is drawn for a speed. No title.
report::XyPlot trialPlot(const core::Trial& trial, TrialPicture picture, const ReferenceTable* published);

}  // namespace sagara::tools
