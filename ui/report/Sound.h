#pragma once

#include <cmath>

#include "ui/report/ReportData.h"

namespace sagara::report {

inline bool isFinite(core::NorthEast p) { return std::isfinite(p.north_m) && std::isfinite(p.east_m); }

/// The report less points that cannot be drawn: one number that is none would spoil a whole page of the PDF.
/// A run has such points only when its recording is damaged.
RunReport withoutBadPoints(const RunReport& report);

}  // namespace sagara::report
