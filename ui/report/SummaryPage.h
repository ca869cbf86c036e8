#pragma once

#include <vector>

#include "ui/report/Flow.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// The page that is signed: lesson, who and when, result, tasks, rubric, room for the assessor. One sheet, or
/// more when there is more to say than fits.
std::vector<Sheet> summarySheets(const RunReport& report);

}  // namespace sagara::report
