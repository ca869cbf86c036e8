#pragma once

#include "app/station/StationRun.h"
#include "ui/theme/Page.h"
#include "ui/trainee/TraineeConsole.h"

namespace sagara::station {

class Station;

/// A run sailed from the trainee's console without a trainer's desk: a watch, or practice alone.
class SailPage final : public ui::Page {
    Q_OBJECT

public:
    /// `ended` opens whatever comes after the run in place of this page.
    using Ended = std::function<void(StationRun& run, const run::RunSummary& summary)>;
    SailPage(Station& station, std::unique_ptr<StationRun> run, ui::ConsoleOptions options, Ended ended);
    ~SailPage() override;

    void setColours(ui::PaletteName name) override { m_console->setColours(name); }
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("console"); }

    StationRun& run() { return *m_run; }
    /// Ends the run and shows what came of it.
    void end();

private:
    Station& m_station;
    std::unique_ptr<StationRun> m_run;
    Ended m_ended;
    ui::TraineeConsole* m_console;
};

}  // namespace sagara::station
