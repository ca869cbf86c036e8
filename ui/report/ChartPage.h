#pragma once

#include "ui/report/Flow.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// The track chart with its inset, scale, north, graticule and legend.
Sheet chartSheet(const RunReport& report);

}  // namespace sagara::report
