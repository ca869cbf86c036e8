#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>

#include "ui/debrief/ChartOverlay.h"
#include "ui/debrief/DebriefPorts.h"
#include "ui/debrief/PlotData.h"
#include "ui/theme/PaletteName.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/PreparedChart.h"

class QLabel;
class QLineEdit;
class QMenu;
class QSplitter;
class QStackedWidget;
class QTimer;

namespace sagara::ui {

class ChartWidget;
class ComparePanel;
class Instruments;
class PlotStack;
class SailPanel;
class ScorePanel;
class TimeAxis;
class Timeline;
class TransportBar;
class ViewsPanel;

/// A recording as it is debriefed, all worked out that takes time.
struct OpenedRecording {
    std::unique_ptr<Replay> replay;
    std::shared_ptr<const PreparedChart> chart;
    std::shared_ptr<const PlotData> plots;
};

/// The debriefing of one recording: chart, views, instruments, score, timeline and plots of the same moment;
/// and "what if", sailed from any second and laid beside it.
class DebriefDesk final : public QWidget {
    Q_OBJECT

public:
    DebriefDesk(const DebriefPorts& ports, OpenedRecording opened, QWidget* parent = nullptr);
    ~DebriefDesk() override;

    void setColours(PaletteName name);
    bool mayLeave();

    Replay& replay() { return *m_replay; }
    Branch* branch() { return m_branch.get(); }
    /// Replay: the recording alone. Sailing: what if, under way. Comparing: both side by side.
    enum class Mode { Replay, Sailing, Comparing };
    Mode mode() const { return m_mode; }
    core::SimTime shown() const;  ///< the moment chart, plots and timeline show

    void goTo(core::SimTime time);
    void step(double seconds);
    void goToMark(int direction);
    void togglePlay();
    void sailFromHere();
    void compare();
    void sailOn();
    void endBranch();
    /// The plots that are shown, to be kept and given back to another desk.
    QString plotsShown() const;
    void showPlots(const QString& kept);
    /// Shows and draws what is now; called by timers, and by tests.
    void refresh();
    void drawViews();

Q_SIGNALS:
    void plotsChosen();  ///< by the person

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* header();
    QWidget* chartPanel();
    QWidget* lowerPanel();
    void fillPlotMenu(QMenu& menu);
    void addNote(bool keep);
    void tell(const QString& words);
    void readMarks();
    void takeOrders();
    void layOut();
    void fitRun();
    void setMode(Mode mode);

    const core::Snapshot& takePicture();
    void refreshChart(const core::Snapshot& now);
    void refreshTracks();
    void refreshGhost();
    void refreshBranchPlots();
    void startBranchWhenReady();
    void showComparison();
    void showShip();

    DebriefPorts m_ports;
    std::unique_ptr<Replay> m_replay;
    std::unique_ptr<Branch> m_branch;  ///< outlived by no panel that shows it
    Mode m_mode = Mode::Replay;
    PaletteName m_colours = PaletteName::Day;
    TimeAxis* m_axis;
    QLabel *m_title, *m_remark, *m_notice;
    ChartWidget* m_chart;
    ChartOverlay* m_overlay;
    QStackedWidget* m_left;
    ScorePanel* m_score;
    Instruments* m_instruments = nullptr;
    ComparePanel* m_compare;
    SailPanel* m_sail = nullptr;
    ViewsPanel* m_views;
    TransportBar* m_transport;
    Timeline* m_timeline;
    PlotStack* m_plots;
    QWidget* m_noteBar;
    QLineEdit* m_noteText;
    QSplitter *m_across, *m_down;
    QTimer *m_frames, *m_beat;

    Replay::Picture m_picture;
    std::shared_ptr<const PlotData> m_plotData;
    std::vector<OverlayTrack::Point> m_way;  ///< of the graded ship, a second apart
    std::vector<ChartTrack> m_targetWays;    ///< whole
    std::vector<core::TrackSample> m_branchTrack;
    std::optional<core::SimTime> m_beyond;  ///< compared beyond the end of the recording
    core::SimTime m_noteAt;
    std::int64_t m_trackedTo_s = -1;
    QElapsedTimer m_branchPlotted;  ///< not valid: to be done
    bool m_exactShown = false;
    bool m_sailWanted = false;
    bool m_haveOrders = false;
    bool m_laidOut = false;
    bool m_divided = false;
    bool m_plotsGiven = false;
    std::pair<std::int64_t, bool> m_chartShows{-1, false};  ///< time of the picture, whether exact
    int m_idleFrames = 0;
};

}  // namespace sagara::ui
