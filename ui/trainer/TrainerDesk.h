#pragma once

#include <QMainWindow>
#include <memory>

#include "render/scene/Stage.h"
#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"
#include "ui/widgets/ChartScene.h"

class QAction;
class QTimer;
class QToolBar;

namespace sagara::ui {

class ChartWidget;
class ClassroomPanel;
class EventBoard;
class HelmPanel;
class Instruments;
class MissionPanel;
class NotesPanel;
class PanelRail;
class ReadingStrip;
class RunBar;
class TrafficBoard;
class ViewportWidget;
struct PreparedChart;

/// The trainer's desk: panels at the left, chart, two views, and everything that is done to a run.
class TrainerDesk final : public QMainWindow {
    Q_OBJECT

public:
    /// `stage` may be null where there is no GL: the views then say so. It shows the run's world already.
    /// `chart`: of the run's area; null: it is made here, which takes a tenth of a second.
    TrainerDesk(ExerciseRun& run, render::Stage* stage, QWidget* parent = nullptr,
                std::shared_ptr<const PreparedChart> chart = nullptr);
    ~TrainerDesk() override;

    /// The chart, everything painted by hand and the icons; ordinary widgets follow the application.
    void setColours(PaletteName name);
    /// One more panel; see PanelRail::add. Its colours and refreshing are the caller's.
    void addPanel(const QString& name, const QString& title, const QString& icon, QWidget* panel);
    /// "mission", "ship", "events", "traffic", "class", "notes".
    void showPanel(const QString& name);

    /// What was sailed before the run was taken up or went back.
    void showSailed(std::vector<ChartTrackPoint> track);
    void setMayGoBack(bool may);
    /// How the space is divided, to be kept and given back before the desk is shown.
    QByteArray layoutKept() const;
    void setLayoutKept(const QByteArray& kept) { m_layoutKept = kept; }

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
    QAction* addTool(QToolBar& bar, const QString& name, const QString& text, const QString& icon,
                     const QString& tip);
    void addChartTools();
    void addNoteTools(QToolBar& bar);
    void addPanels();
    void layOut(render::Stage* stage);
    QWidget* views(render::Stage* stage);
    QWidget* viewPanel(std::size_t index);
    void showRoute();
    void refreshChart(const core::Snapshot& now);
    void refreshForces(const core::Snapshot& now);
    void predict();
    void printChart();

    ExerciseRun& m_run;
    render::Stage* m_stage;
    ChartWidget* m_chart;
    PanelRail* m_rail;
    std::vector<ViewportWidget*> m_views;
    RunBar* m_bar;
    ReadingStrip* m_readings = nullptr;
    Instruments* m_instruments = nullptr;
    HelmPanel* m_helm = nullptr;
    ClassroomPanel* m_class = nullptr;
    EventBoard* m_events;
    TrafficBoard* m_traffic;
    NotesPanel* m_notes;
    MissionPanel* m_mission;
    std::vector<std::pair<QAction*, QString>> m_icons;
    QAction* m_showForces = nullptr;
    QTimer* m_frames;
    QTimer* m_beat;
    PaletteName m_palette = PaletteName::Day;
    bool m_laidOut = false;
    QByteArray m_layoutKept;
    std::int64_t m_tick = -1;
    std::int64_t m_trackedTo_s = -1;
    std::int64_t m_predictedAt_s = -1;
    std::size_t m_zonesDone = static_cast<std::size_t>(-1);  ///< tasks done when the zones were made
    double m_forceScale_NPerPx = 0.0;
};

}  // namespace sagara::ui
