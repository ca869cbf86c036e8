#pragma once

#include "ui/report/Flow.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// PASSED or NOT PASSED, why, and the automatic score with its pass mark.
Block resultBand(const RunReport& report);

}  // namespace sagara::report
