#pragma once

#include <vector>

#include "ui/report/Flow.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// Every deduction with its number, and below them where the report comes from.
std::vector<Sheet> deductionSheets(const RunReport& report);

}  // namespace sagara::report
