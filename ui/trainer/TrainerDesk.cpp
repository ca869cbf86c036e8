#include "ui/trainer/TrainerDesk.h"

#include <QAction>
#include <QComboBox>
#include <QFutureWatcher>
#include <QLabel>
#include <QSplitter>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <utility>

#include "core/exercise/Forces.h"
#include "core/exercise/Prediction.h"
#include "ui/run/RunTexts.h"
#include "ui/theme/Theme.h"
#include "ui/trainer/ClassroomPanel.h"
#include "ui/trainer/EventBoard.h"
#include "ui/trainer/HelmPanel.h"
#include "ui/trainer/Instruments.h"
#include "ui/trainer/MissionPanel.h"
#include "ui/trainer/NotesPanel.h"
#include "ui/trainer/PanelRail.h"
#include "ui/trainer/ReadingStrip.h"
#include "ui/trainer/RunBar.h"
#include "ui/trainer/TrafficBoard.h"
#include "ui/viewport/ViewportWidget.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/ForceArrows.h"
#include "ui/widgets/PreparedExercise.h"
#include "ui/widgets/PrintChart.h"
#include "ui/widgets/SnapshotScene.h"

namespace sagara::ui {
namespace {

constexpr int kFrame_ms = 40, kBeat_ms = 200;
constexpr double kPrediction_s = 360.0, kPredictionStep_s = 10.0;
constexpr double kLongestArrow_px = 110.0;

}  // namespace

TrainerDesk::TrainerDesk(ExerciseRun& run, render::Stage* stage, QWidget* parent,
                         std::shared_ptr<const PreparedChart> chart)
    : QMainWindow(parent),
      m_run(run),
      m_stage(stage),
      m_chart(new ChartWidget(this)),
      m_rail(new PanelRail(this)),
      m_bar(new RunBar(run, this)),
      m_events(new EventBoard(run, this)),
      m_traffic(new TrafficBoard(run, *m_chart, this)),
      m_notes(new NotesPanel(run, this)),
      m_mission(new MissionPanel(run, this)),
      m_frames(new QTimer(this)),
      m_beat(new QTimer(this)) {
    setWindowFlags(Qt::Widget);  // a page of the station, though it has tool bars
    setContextMenuPolicy(Qt::NoContextMenu);
    const core::World& world = *run.world();
    setWindowTitle(tr("%1 - Sagara").arg(QString::fromStdString(world.scenarioName)));
    m_chart->setChart(chart ? std::move(chart) : prepareChart(run.world()));
    m_chart->setRoute(world.route);
    m_chart->setTracks({ChartTrack{}});
    m_chart->setObjectName(QStringLiteral("chart"));

    auto* const bar = new QToolBar(tr("Run"), this);
    bar->setObjectName(QStringLiteral("run-bar"));
    bar->setMovable(false);
    bar->addWidget(m_bar);
    addToolBar(Qt::TopToolBarArea, bar);
    connect(m_bar, &RunBar::endWanted, this, &TrainerDesk::endWanted);
    connect(m_bar, &RunBar::goBackWanted, this, &TrainerDesk::goBackWanted);
    connect(m_bar, &RunBar::consoleWanted, this, &TrainerDesk::consoleWanted);
    addChartTools();
    addPanels();
    layOut(stage);
    setColours(m_palette);

    connect(m_frames, &QTimer::timeout, this, &TrainerDesk::drawViews);
    connect(m_beat, &QTimer::timeout, this, &TrainerDesk::refresh);
    m_frames->start(kFrame_ms);
    m_beat->start(kBeat_ms);
    refresh();
}

TrainerDesk::~TrainerDesk() = default;

QAction* TrainerDesk::addTool(QToolBar& bar, const QString& name, const QString& text, const QString& icon,
                              const QString& tip) {
    QAction* const action = bar.addAction(text);
    action->setObjectName(name);
    action->setToolTip(tip);
    m_icons.emplace_back(action, icon);
    return action;
}

void TrainerDesk::addChartTools() {
    auto* const bar = new QToolBar(tr("Chart"), this);
    bar->setObjectName(QStringLiteral("chart-bar"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setIconSize({18, 18});
    addToolBarBreak();
    addToolBar(Qt::TopToolBarArea, bar);
    QAction* const whole = addTool(*bar, QStringLiteral("whole-area"), tr("Whole area"),
                                   QStringLiteral("chart"), tr("Show all of the chart"));
    connect(whole, &QAction::triggered, m_chart, &ChartWidget::fitArea);
    QAction* const follow =
        addTool(*bar, QStringLiteral("follow-ship"), tr("Follow"), QStringLiteral("own-ship-iec"),
                tr("Keep the own ship in the middle (Home)"));
    follow->setCheckable(true);
    connect(follow, &QAction::toggled, m_chart, &ChartWidget::follow);
    connect(m_chart, &ChartWidget::followingChanged, follow, &QAction::setChecked);
    QAction* const headUp =
        addTool(*bar, QStringLiteral("head-up"), tr("Head up"), QStringLiteral("heading-h-up-proposal"),
                tr("The own ship's heading is up, not north"));
    headUp->setCheckable(true);
    connect(headUp, &QAction::toggled, m_chart, &ChartWidget::setHeadUp);
    bar->addSeparator();
    using Tool = ChartTools::Tool;
    const auto measuring = [&](QAction* action, Tool tool) {
        action->setCheckable(true);
        connect(action, &QAction::toggled, this, [this, tool](bool on) {
            if (on || m_chart->tool() == tool) m_chart->chooseTool(on ? tool : Tool::None);
        });
        connect(m_chart, &ChartWidget::toolChanged, action,
                [action, tool](Tool now) { action->setChecked(now == tool); });
    };
    measuring(addTool(*bar, QStringLiteral("range-bearing"), tr("Range, bearing"),
                      QStringLiteral("radar-electronic-range-and-bearing-proposal"),
                      tr("Drag a line on the chart (Esc ends)")),
              Tool::RangeBearing);
    measuring(
        addTool(*bar, QStringLiteral("parallel-rule"), tr("Parallel rule"), QStringLiteral("measure-google"),
                tr("Drag a line that keeps its direction; Shift turns it (Esc ends)")),
        Tool::ParallelRule);
    bar->addSeparator();
    m_showForces =
        addTool(*bar, QStringLiteral("show-forces"), tr("Forces"), QStringLiteral("dynamic-positioning"),
                tr("Arrows for what pushes the own ship: hull, rudder, propeller, wind, waves, ..."));
    m_showForces->setCheckable(true);
    m_showForces->setEnabled(!m_run.world()->ships.empty());
    connect(m_showForces, &QAction::toggled, this, [this](bool on) {
        if (!on) m_chart->setForces({});
        refresh();
    });
    QAction* const print = addTool(*bar, QStringLiteral("print"), tr("Print"), QStringLiteral("print"),
                                   tr("Print chart: what it shows now, on paper or as a PDF (Ctrl+P)"));
    print->setShortcut(QKeySequence::Print);
    connect(print, &QAction::triggered, this, &TrainerDesk::printChart);
    bar->addSeparator();
    addNoteTools(*bar);
}

void TrainerDesk::addNoteTools(QToolBar& bar) {
    QAction* const mark =
        addTool(bar, QStringLiteral("bookmark"), tr("Bookmark"), QStringLiteral("waypoint-add-iec"),
                tr("Mark this moment for the debriefing (Ctrl+B)"));
    mark->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_B));
    connect(mark, &QAction::triggered, m_notes, &NotesPanel::bookmark);
    QAction* const note =
        addTool(bar, QStringLiteral("note"), tr("Note"), QStringLiteral("waypoint-edit-iec"),
                tr("Write a note to this moment (Ctrl+N)"));
    note->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_N));
    connect(note, &QAction::triggered, this, [this] {
        showPanel(QStringLiteral("notes"));
        m_notes->beginNote();
    });
}

void TrainerDesk::addPanels() {
    m_rail->add(QStringLiteral("mission"), tr("Mission"), QStringLiteral("route-monitoring-proposal"),
                m_mission, false);
    if (!m_run.world()->ships.empty()) {
        m_instruments = new Instruments(*m_run.world(), 0, this);
        m_helm = new HelmPanel(m_run, 0, this);
        m_class = new ClassroomPanel(m_run, 0, this);
        auto* const ship = new QWidget(this);
        auto* const column = new QVBoxLayout(ship);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(m_helm);
        column->addWidget(m_instruments, 1);
        m_rail->add(QStringLiteral("ship"), tr("Own ship"), QStringLiteral("conning-iec"), ship);
    }
    m_rail->add(QStringLiteral("events"), tr("Events"), QStringLiteral("wind"), m_events);
    m_rail->add(QStringLiteral("traffic"), tr("Traffic"), QStringLiteral("ship"), m_traffic, false);
    if (m_class != nullptr)
        m_rail->add(QStringLiteral("class"), tr("Class"), QStringLiteral("user-profiles"), m_class);
    m_rail->add(QStringLiteral("notes"), tr("Notes"), QStringLiteral("waypoint-edit-iec"), m_notes, false);
}

void TrainerDesk::addPanel(const QString& name, const QString& title, const QString& icon, QWidget* panel) {
    m_rail->add(name, title, icon, panel);
    m_rail->setColours(m_palette);
}

void TrainerDesk::showPanel(const QString& name) { m_rail->showPanel(name); }

void TrainerDesk::setColours(PaletteName name) {
    m_palette = name;
    m_chart->setColours(name);
    m_rail->setColours(name);
    m_traffic->setColours(name);
    if (m_class != nullptr) m_class->setColours(name);
    for (const auto& [action, icon] : m_icons) action->setIcon(themedIcon(icon, name));
}

void TrainerDesk::showSailed(std::vector<ChartTrackPoint> track) {
    m_chart->setTracks({ChartTrack{std::move(track), true}});
}

void TrainerDesk::setMayGoBack(bool may) { m_bar->setMayGoBack(may); }

/// Panels, chart and views side by side; what lies between them can be dragged.
void TrainerDesk::layOut(render::Stage* stage) {
    auto* const middle = new QWidget(this);
    auto* const column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    if (!m_run.world()->ships.empty()) {
        m_readings = new ReadingStrip(*m_run.world(), 0, middle);
        column->addWidget(m_readings);
    }
    column->addWidget(m_chart, 1);
    auto* const splitter = new QSplitter(Qt::Horizontal, this);
    splitter->setObjectName(QStringLiteral("desk-parts"));
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_rail);
    splitter->addWidget(middle);
    splitter->addWidget(views(stage));
    splitter->setStretchFactor(0, 0);
    splitter->setStretchFactor(1, 3);
    splitter->setStretchFactor(2, 2);
    setCentralWidget(splitter);
}

QWidget* TrainerDesk::viewPanel(std::size_t index) {
    auto* const panel = new QWidget(this);
    auto* const layout = new QVBoxLayout(panel);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    auto* const camera = new QComboBox(panel);
    camera->setToolTip(
        tr("Drag to look round, wheel or B for glasses, double click ahead; free: W A S D R F"));
    const std::pair<QString, CameraKind> kinds[] = {{tr("Bridge"), CameraKind::Bridge},
                                                    {tr("Port wing"), CameraKind::WingPort},
                                                    {tr("Starboard wing"), CameraKind::WingStarboard},
                                                    {tr("Chase"), CameraKind::Chase},
                                                    {tr("Shore"), CameraKind::Shore},
                                                    {tr("Free"), CameraKind::Free}};
    for (const auto& [name, kind] : kinds) camera->addItem(name, static_cast<int>(kind));
    ViewportWidget* const view = m_views[index];
    connect(camera, &QComboBox::activated, view, [view, camera](int at) {
        view->setCameraKind(static_cast<CameraKind>(camera->itemData(at).toInt()));
    });
    if (index == 1) {
        camera->setCurrentIndex(3);
        view->setCameraKind(CameraKind::Chase);
    }
    layout->addWidget(camera);
    layout->addWidget(view, 1);
    return panel;
}

QWidget* TrainerDesk::views(render::Stage* stage) {
    auto* const both = new QWidget(this);
    both->setObjectName(QStringLiteral("views"));
    both->setMinimumWidth(260);
    auto* const layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    if (stage == nullptr) {
        auto* const none = new QLabel(tr("No 3D views: this machine has no OpenGL 3.3."), both);
        none->setAlignment(Qt::AlignCenter);
        none->setWordWrap(true);
        layout->addWidget(none);
        return both;
    }
    const auto& places = m_run.world()->area.places;
    for (std::size_t i = 0; i < 2; ++i) {
        m_views.push_back(new ViewportWidget(stage->addViewport(320, 180), both));
        for (const core::Place& place : places)
            if (place.kind == "entrance") m_views[i]->rig().shore = place.position;
        layout->addWidget(viewPanel(i), 1);
    }
    return both;
}

/// Sizes are known only now: room for the panels by the width of the desk, and the chart at the route.
void TrainerDesk::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_laidOut, true)) return;
    QTimer::singleShot(0, this, [this] {
        const int left = std::clamp(width() / 4, 390, 480);
        const int right = m_stage == nullptr ? 260 : std::clamp(width() * 3 / 10, 300, 760);
        auto* const parts = findChild<QSplitter*>(QStringLiteral("desk-parts"));
        if (m_layoutKept.isEmpty() || !parts->restoreState(m_layoutKept))
            parts->setSizes({left, width() - left - right, right});
        QTimer::singleShot(0, this, [this] { showRoute(); });
    });
}

QByteArray TrainerDesk::layoutKept() const {
    return findChild<QSplitter*>(QStringLiteral("desk-parts"))->saveState();
}

void TrainerDesk::showRoute() {
    chart::Extent extent;
    for (const auto& waypoint : m_run.world()->route.waypoints) extent.include(waypoint.position);
    for (const auto& ship : m_run.latest()->ships) extent.include(ship.motion.position());
    if (extent.empty) return;
    const core::NorthEast margin{0.12 * extent.height_m() + 200.0, 0.12 * extent.width_m() + 200.0};
    extent.include(extent.southWest - margin);
    extent.include(extent.northEast + margin);
    m_chart->fitTo(extent);
}

void TrainerDesk::drawViews() {
    if (m_stage == nullptr || m_views.empty()) return;
    const ExerciseRun::Picture picture = m_run.toDraw();
    render::Moment moment = render::momentOf(picture.snapshot);
    moment.time = picture.time;
    for (ViewportWidget* view : m_views) {
        view->refresh();
        view->aim(*m_run.world(), moment);
    }
    m_stage->drawSoon(std::move(moment));
}

void TrainerDesk::refresh() {
    const auto now = m_run.latest();
    m_bar->refresh();
    m_mission->refresh();
    m_notes->refresh();
    m_events->refresh(*now);
    m_traffic->refresh(*now);
    if (m_readings != nullptr) m_readings->show(*now);
    if (m_instruments != nullptr) m_instruments->show(*now);
    if (m_helm != nullptr) m_helm->refresh();
    if (m_run.over()) {  // no order is carried out any more
        m_events->setEnabled(false);
        if (m_helm != nullptr) m_helm->setEnabled(false);
    }
    refreshForces(*now);
    refreshChart(*now);
}

/// Only where they are looked at: they take about as long as a tick.
void TrainerDesk::refreshForces(const core::Snapshot& now) {
    if (m_class == nullptr || now.ships.empty()) return;
    const bool onChart = m_showForces->isChecked();
    std::vector<ShownForce> forces;
    if (onChart || m_class->isVisible())
        forces = shownForces(core::forcesOn(*m_run.world(), m_run.state(), 0),
                             m_run.world()->ships[0]->vessel.hull.lengthOverall_m);
    m_class->refresh(now, forces);
    if (!onChart) return;
    m_forceScale_NPerPx = forceScale_NPerPx(forces, kLongestArrow_px, m_forceScale_NPerPx);
    m_chart->setForces(std::move(forces), m_forceScale_NPerPx);
}

void TrainerDesk::refreshChart(const core::Snapshot& now) {
    const core::World& world = *m_run.world();
    m_chart->setOwnShips(ownShipsOf(world, now));
    m_chart->setTargets(targetsOf(world, now));
    m_chart->setAnchors(anchorsOf(world, now));
    const auto done = static_cast<std::size_t>(
        std::count_if(now.tasks.begin(), now.tasks.end(), [](const core::TaskView& t) { return t.done; }));
    if (std::exchange(m_zonesDone, done) != done) m_chart->setZones(zonesOf(world.mission, now.tasks));
    const std::int64_t second = now.time().us / 1'000'000;
    if (now.tick < std::exchange(m_tick, now.tick)) {  // somebody went back: so does the track
        std::vector<ChartTrack> tracks = m_chart->scene().tracks;
        for (ChartTrack& track : tracks)
            if (track.ownShip)
                std::erase_if(track.points, [&](const auto& p) { return p.time_s > now.time().seconds(); });
        m_chart->setTracks(std::move(tracks));
        m_trackedTo_s = m_predictedAt_s = -1;
    }
    if (now.ships.empty() || second == m_trackedTo_s) return;
    m_trackedTo_s = second;
    m_chart->extendTrack(0, {now.time().seconds(), now.ships[0].motion.position()});
    if (second - m_predictedAt_s >= 2) predict();
}

void TrainerDesk::printChart() {
    const core::World& world = *m_run.world();
    const core::SimTime time = m_run.latest()->time();
    askAndPrint(this, sheetOf(*m_chart, QString::fromStdString(world.scenarioName),
                              tr("%1, %2 local, %3 of the exercise")
                                  .arg(QString::fromStdString(world.area.name), localTime(world, time),
                                       elapsed(time))));
}

/// Takes some 30 ms, so aside.
void TrainerDesk::predict() {
    m_predictedAt_s = m_trackedTo_s;
    auto* const watcher = new QFutureWatcher<std::vector<core::PredictedPose>>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] {
        m_chart->setPredictions({predictionOf(*m_run.world(), 0, watcher->result())});
        watcher->deleteLater();
    });
    watcher->setFuture(QtConcurrent::run([world = m_run.world(), state = m_run.state()] {
        return core::predict(*world, state, 0, kPrediction_s, kPredictionStep_s);
    }));
}

}  // namespace sagara::ui
