#pragma once

#include <string>

#include "core/identify/StandardTrials.h"
#include "ui/report/PilotCard.h"

namespace sagara::ui {

/// The pilot card of a vessel from her document and her trials. Runs the model for speeds and stops: a second
/// or two, so not in the thread of the interface.
report::PilotCardData pilotCardOf(const core::Vessel& vessel, const core::StandardTrials& trials,
                                  const std::string& date);

}  // namespace sagara::ui
