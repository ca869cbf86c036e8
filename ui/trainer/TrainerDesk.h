#pragma once

#include <QMainWindow>
#include <memory>

#include "render/scene/Stage.h"
#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"
#include "ui/widgets/ChartScene.h"

class QTimer;

namespace sagara::ui {

class ChartWidget;
class EventBoard;
class HelmPanel;
class Instruments;
class MissionPanel;
class RunBar;
class ViewportWidget;

/// The trainer's desk: chart, two views, instruments, mission, and everything that is done to a run.
class TrainerDesk final : public QMainWindow {
    Q_OBJECT

public:
    /// `stage` may be null where there is no GL: the views then say so. It shows the run's world already.
    TrainerDesk(ExerciseRun& run, render::Stage* stage, QWidget* parent = nullptr);
    ~TrainerDesk() override;

    /// Another panel among those on the left; the desk owns it.
    void addPanel(const QString& title, const QString& name, QWidget* panel);
    /// What was sailed before the run was taken up or went back.
    void showSailed(std::vector<ChartTrackPoint> track);
    void setMayGoBack(bool may);
    void setColours(PaletteName name);

    /// Draws and shows what is now; called by a timer, and by tests.
    void drawViews();
    void refresh();

Q_SIGNALS:
    void endWanted();
    void goBackWanted(std::int64_t second);
    void consoleWanted();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addViews(render::Stage* stage);
    void addPanels();
    void addChartTools();
    QWidget* viewPanel(std::size_t index);
    void refreshChart(const core::Snapshot& now);
    void predict();

    ExerciseRun& m_run;
    render::Stage* m_stage;
    ChartWidget* m_chart;
    std::vector<ViewportWidget*> m_views;
    RunBar* m_bar;
    Instruments* m_instruments = nullptr;
    HelmPanel* m_helm = nullptr;
    EventBoard* m_events;
    MissionPanel* m_mission;
    QTimer* m_frames;
    QTimer* m_beat;
    bool m_laidOut = false;
    std::int64_t m_trackedTo_s = -1;
    std::int64_t m_predictedAt_s = -1;
};

}  // namespace sagara::ui
