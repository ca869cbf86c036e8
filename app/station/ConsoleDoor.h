#pragma once

#include "app/station/Frame.h"
#include "ui/run/ExerciseRun.h"
#include "ui/trainee/ConsoleOptions.h"

namespace sagara::ui {
class ConsolePage;
class TraineeConsole;
}  // namespace sagara::ui

namespace sagara::station {

/// The trainee's console as a page of the station's window. The run outlives it. Colours are the window's.
ui::ConsolePage* consolePage(Frame& frame, ui::ExerciseRun& run, ui::ConsoleOptions options);

/// The same in a window of its own while the desk runs the exercise: full screen on the second monitor where
/// there is one, else 1280 x 720. F11 changes between the two, F1 shows help. Shown already; deletes itself
/// when it is closed; to be deleted before the run. The desk draws the stage: options.drawsStage is false
/// unless the caller has none open.
ui::TraineeConsole* consoleWindow(Frame& frame, ui::ExerciseRun& run, ui::ConsoleOptions options);

}  // namespace sagara::station
