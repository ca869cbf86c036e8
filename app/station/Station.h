#pragma once

#include <QStackedWidget>
#include <memory>

#include "app/station/StationRun.h"
#include "render/scene/Stage.h"

namespace sagara::ui {
class StartPage;
class TrainerDesk;
struct StartChoice;
}  // namespace sagara::ui

namespace sagara::station {

/// The station's window: the start page, or the desk of the run that is on.
class Station final : public QStackedWidget {
    Q_OBJECT

public:
    Station(run::Store& store, render::StageOptions stage);
    ~Station() override;

    /// Opens the desk. The error is for the person who chose.
    std::optional<std::string> open(const RunRequest& request);
    /// Ends the run and shows its result; then the start page again.
    void endRun();
    StationRun* run() const { return m_run.get(); }
    ui::TrainerDesk* desk() const { return m_desk; }
    ui::StartPage* startPage() const { return m_start; }

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    bool confirmed(const QString& question);
    QString resultText(const run::RunSummary& summary) const;

    run::Store& m_store;
    render::StageOptions m_stageOptions;
    std::unique_ptr<StationRun> m_run;
    std::unique_ptr<render::Stage> m_stage;
    ui::StartPage* m_start;
    ui::TrainerDesk* m_desk = nullptr;
};

}  // namespace sagara::station
