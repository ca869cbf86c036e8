#pragma once

#include <vector>

#include "ui/report/ReportData.h"
#include "ui/report/TimePlot.h"

namespace sagara::report {

/// What is plotted of a run, from top to bottom. A new plot is one function and one line in TrackPlots.cpp.
std::vector<Plot> trackPlots(const RunReport& report);

}  // namespace sagara::report
