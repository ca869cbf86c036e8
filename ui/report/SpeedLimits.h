#pragma once

#include <vector>

#include "ui/report/ReportData.h"

namespace sagara::report {

/// Speed limit in m/s at each point of the track, 0 where none is known: as recorded, else that of the
/// route's leg the ship is on. Empty when none is known anywhere.
std::vector<double> speedLimits_mps(const RunReport& report);

}  // namespace sagara::report
