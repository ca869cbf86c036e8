#pragma once

#include "ui/report/Flow.h"

namespace sagara::report {

/// Room for the assessor: comment, decision, signatures. The score is advice; this is the assessment.
Block signOff();

}  // namespace sagara::report
