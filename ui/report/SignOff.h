#pragma once

#include "ui/report/Flow.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// The assessor's part: comment, decision, signatures. What was not entered is left as room to write. The
/// score is advice; this is the assessment. Long comments run over pages.
std::vector<Block> signOff(const RunReport& report);

}  // namespace sagara::report
