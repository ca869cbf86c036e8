#include "app/station/BridgeLink.h"
#include "app/station/ConsoleDoor.h"
#include "app/station/DebriefDoor.h"
#include "app/station/Doors.h"
#include "app/station/PractiseDoor.h"
#include "app/station/Station.h"
#include "ui/hints/HintsPanel.h"
#include "ui/trainee/ConsolePage.h"

namespace sagara::station {
namespace {

/// The console of who sails alone: starts and freezes the run herself, and is given hints if she wants them.
ui::Page* consoleAlone(Station& station, ui::ExerciseRun& run, const PractiseOptions& wanted) {
    ui::ConsoleOptions options;
    options.prediction = wanted.prediction;
    options.chart = wanted.chart;
    options.showRunControls = true;
    options.startsRun = true;
    options.keys = false;  // BridgeLink takes them, as they are mapped
    ui::ConsolePage* const page = consolePage(station, run, options);
    if (wanted.hints) page->console().addPage(new ui::HintsPanel(run), QObject::tr("Hints"));
    new BridgeLink(station.input(), station.sound(), page->console(), run);
    return page;
}

}  // namespace

ui::Page* alonePage(Station& station) {
    PractiseWays ways;
    ways.console = [&station](ui::ExerciseRun& run, const PractiseOptions& wanted) {
        return consoleAlone(station, run, wanted);
    };
    ways.debrief = [&station](const std::filesystem::path& recording,
                              double time_s) -> std::optional<std::string> {
        const auto page = debriefPage(station, recording, nullptr, time_s);
        if (!page) return page.error();
        station.openPage(*page);
        return std::nullopt;
    };
    return practisePage(station, std::move(ways));
}

}  // namespace sagara::station
