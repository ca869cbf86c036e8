#pragma once

#include <string>

#include "core/identify/StandardTrials.h"
#include "ui/report/PilotCard.h"

namespace sagara::ui {

/// With which model and in what water a vessel was tried.
struct TriedIn {
    std::string title = "Loaded, deep water";
    std::string model = {};
    double depth_m = core::kDeepWater_m;
};

/// The pilot card of a vessel from her document and her trials, which must be of this model and depth. Runs
/// the model for speeds and stops: a second or two, so not in the thread of the interface.
report::PilotCardData pilotCardOf(const core::Vessel& vessel, const core::StandardTrials& trials,
                                  const std::string& date, const TriedIn& in = {});

/// One more loading or depth for the wheelhouse poster.
report::PilotCardData::Condition conditionOf(const core::Vessel& vessel, const core::StandardTrials& trials,
                                             const TriedIn& in);

}  // namespace sagara::ui
