#include "app/station/RosterDoor.h"

#include "app/station/ResultStore.h"
#include "app/station/RosterStore.h"
#include "ui/roster/ResultPage.h"
#include "ui/roster/RosterPage.h"

namespace sagara::station {

ui::Page* rosterPage(Frame& frame) { return new roster::RosterPage(std::make_unique<RosterStore>(frame)); }

ui::Page* resultPage(Frame& frame, const std::filesystem::path& recording, const run::RunSummary& summary) {
    return new roster::ResultPage(std::make_unique<ResultStore>(frame, recording, summary));
}

ui::Page* resultPage(Frame& frame, db::RunId run) {
    return new roster::ResultPage(std::make_unique<ResultStore>(frame, run));
}

}  // namespace sagara::station
