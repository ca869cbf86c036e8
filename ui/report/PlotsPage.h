#pragma once

#include "ui/report/Flow.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// The plots over time on one time axis, with the tasks and the deductions at their moments.
Sheet plotsSheet(const RunReport& report);

}  // namespace sagara::report
