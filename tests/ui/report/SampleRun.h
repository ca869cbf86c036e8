#pragma once

#include "ui/report/ReportData.h"

namespace sagara::report::test {

/// A made-up run of the lesson basic-navigation in the real area Galle, along the waypoints of the scenario
/// file: good enough to look at, never to be taken for physics. Passed, with nothing deducted.
RunReport passedRun();
/// The same badly sailed: not passed, with a dozen deductions.
RunReport failedRun();

}  // namespace sagara::report::test
