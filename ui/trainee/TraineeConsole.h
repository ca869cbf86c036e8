#pragma once

#include <QWidget>
#include <memory>

#include "core/bridge/EchoSounder.h"
#include "core/vessel/Machinery.h"
#include "render/scene/Stage.h"
#include "ui/run/ExerciseRun.h"
#include "ui/trainee/ConsoleOptions.h"

class QLabel;
class QSplitter;
class QStackedWidget;
class QTabWidget;
class QTimer;

namespace sagara::ui {

namespace console {
class AlarmStrip;
class Briefing;
class ChartPage;
class ControlRow;
class InstrumentStrip;
class RadarPage;
class RunControls;
class SoundingPage;
class ViewPanel;
}  // namespace console

/// The bridge of one own ship as a trainee has it: view, chart, radar, sonar, instruments, controls; nothing
/// that only a trainer knows. A page of the station or a window of its own on another screen.
class TraineeConsole final : public QWidget {
    Q_OBJECT

public:
    /// `stage` may be null where there is no GL; it shows the run's world already. Both outlive the console.
    TraineeConsole(ExerciseRun& run, render::Stage* stage, const ConsoleOptions& options,
                   QWidget* parent = nullptr);
    ~TraineeConsole() override;

    void setColours(PaletteName name);
    /// One more tab beside chart, radar and sonar (hints of a lesson).
    void addPage(QWidget* page, const QString& title);
    /// Whether the bridge is shown, not the briefing.
    bool onWatch() const;

    /// Shows what is now; called by timers, and by tests.
    void drawFrame();
    void refresh();

public Q_SLOTS:
    void takeWatch();
    void showBriefing();
    // From input devices.
    void setHelm(double rudder_rad);
    void setTelegraph(int shaft, sagara::core::TelegraphStep step);
    void setThruster(int thruster, double share);
    void setPitch(int shaft, double pitch);  ///< over the design pitch
    void setAzimuth(int shaft, double angle_rad);
    void shiftPitch(int shaft, int steps);    ///< of 5 %
    void shiftAzimuth(int shaft, int steps);  ///< of 5 degrees
    void soundHorn(bool on);
    void acknowledgeAlarms();
    void look(double yaw_radps);  ///< the view turns so fast until the next call

Q_SIGNALS:
    void watchTaken();
    void alarm(bool on);
    void horn(bool on);
    void endWanted();
    void helmGiven(double rudder_rad);
    void telegraphGiven(int shaft, sagara::core::TelegraphStep step);
    void thrusterGiven(int thruster, double share);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    QWidget* makeBridge(render::Stage* stage);
    QWidget* makeHeader();
    void addKeys();
    void takeBearing(double grid_rad);
    void updateAlarms(const core::Snapshot& now);
    void showState();

    ExerciseRun& m_run;
    render::Stage* m_stage;
    ConsoleOptions m_options;
    core::EchoSounder m_sounder;
    QStackedWidget* m_pages;
    console::Briefing* m_briefing;
    QWidget* m_header;
    QSplitter* m_middle;
    QTabWidget* m_tabs;
    console::AlarmStrip* m_alarms;
    console::RunControls* m_runControls = nullptr;
    QLabel* m_state;
    console::InstrumentStrip* m_instruments;
    console::ViewPanel* m_view;
    console::ChartPage* m_chart;
    console::RadarPage* m_radar;
    console::SoundingPage* m_sounding;
    console::ControlRow* m_controls;
    QTimer* m_frames;
    QTimer* m_beat;
    int m_letters_px = 0;
    double m_look_radps = 0.0;
    double m_lastRudder_rad = 0.0;
    core::SimTime m_lastRudderAt{-1};
    bool m_rudderMoves = false;
};

}  // namespace sagara::ui
