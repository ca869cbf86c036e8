#pragma once

#include <functional>

#include "app/station/Frame.h"
#include "ui/run/ExerciseRun.h"
#include "ui/widgets/PreparedChart.h"

namespace sagara::station {

/// What the console of who sails alone is to have beside the usual.
struct PractiseOptions {
    bool prediction = true;  ///< on the chart
    bool hints = true;       ///< a ui::HintsPanel
    std::shared_ptr<const ui::PreparedChart> chart = nullptr;
};

struct PractiseWays {
    /// The page a run is sailed from; it does not end the run, leaving it does.
    std::function<ui::Page*(ui::ExerciseRun&, const PractiseOptions&)> console;
    /// The debriefing of a recording at that second; empty: Frame::openDebrief, from the start.
    std::function<std::optional<std::string>(const std::filesystem::path& recording, double time_s)> debrief;
};

/// Sailing without a trainer: choice, run of type self-study, result.
ui::Page* practisePage(Frame& frame, PractiseWays ways);

}  // namespace sagara::station
