#pragma once

#include <memory>

#include "ui/theme/PaletteName.h"

namespace sagara::ui {

struct PreparedChart;

/// How a trainee's console is used.
struct ConsoleOptions {
    std::size_t ship = 0;          ///< of World::ships
    bool briefing = true;          ///< shown first; else the bridge at once
    bool prediction = false;       ///< six minutes ahead on the chart
    bool showRunControls = false;  ///< start, freeze, pace, end: self-study
    bool startsRun = false;        ///< taking the watch starts the exercise
    bool drawsStage = true;        ///< false where another window draws the same stage at its own pace
    bool keys = true;              ///< orders by key; false where ui/input watches this window
    PaletteName colours = PaletteName::Day;
    /// Of the run's area; null: it is made with the console, which takes a tenth of a second.
    std::shared_ptr<const PreparedChart> chart = nullptr;
};

}  // namespace sagara::ui
