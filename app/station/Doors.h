#pragma once

#include "app/station/Frame.h"
#include "app/station/StationRun.h"

/// Which pages there are and how one leads to another.
namespace sagara::station {

class Station;

ui::Page* homePage(Station& station);
ui::Page* settingsPageOf(Station& station);
void showAbout(Station& station, QWidget* parent);

/// The trainee's console of a run that the trainer's desk has; a window of its own.
QWidget* traineeWindow(Frame& frame, StationRun& run);
/// The result of a run that has ended, in place of the page it was sailed from.
void showResult(Frame& frame, StationRun& run, const run::RunSummary& summary);

}  // namespace sagara::station
