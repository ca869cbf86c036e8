#include "ui/trainer/TrainerDesk.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QFutureWatcher>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <utility>

#include "core/exercise/Prediction.h"
#include "ui/trainer/EventBoard.h"
#include "ui/trainer/HelmPanel.h"
#include "ui/trainer/Instruments.h"
#include "ui/trainer/MissionPanel.h"
#include "ui/trainer/RunBar.h"
#include "ui/viewport/ViewportWidget.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/SnapshotScene.h"

namespace sagara::ui {
namespace {

constexpr int kLeftLeast_px = 310;  ///< the widest row of the instruments
constexpr int kFrame_ms = 50, kBeat_ms = 200;
constexpr double kUnderKeel_m = 1.5;  ///< added to the draught for the safety contour
constexpr double kPrediction_s = 360.0, kPredictionStep_s = 10.0;

QScrollArea* scrolled(QWidget* inside) {
    auto* const area = new QScrollArea;
    area->setWidget(inside);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(kLeftLeast_px);
    return area;
}

}  // namespace

TrainerDesk::TrainerDesk(ExerciseRun& run, render::Stage* stage, QWidget* parent)
    : QMainWindow(parent),
      m_run(run),
      m_stage(stage),
      m_chart(new ChartWidget(this)),
      m_bar(new RunBar(run, this)),
      m_events(new EventBoard(run, this)),
      m_mission(new MissionPanel(run, this)),
      m_frames(new QTimer(this)),
      m_beat(new QTimer(this)) {
    setWindowFlags(Qt::Widget);  // a page of the station, though it has docks
    const core::World& world = *run.world();
    setWindowTitle(tr("%1 - Sagara").arg(QString::fromStdString(world.scenarioName)));
    double safety_m = 5.0;
    if (!world.ships.empty()) safety_m = world.ships[0]->vessel.hull.draught_m + kUnderKeel_m;
    m_chart->setChart(prepareChart(std::shared_ptr<const core::Area>(run.world(), &world.area), safety_m));
    m_chart->setRoute(world.route);
    m_chart->setTracks({ChartTrack{}});
    m_chart->setObjectName(QStringLiteral("chart"));
    setCentralWidget(m_chart);

    auto* const bar = new QToolBar(tr("Run"), this);
    bar->setObjectName(QStringLiteral("run-bar"));
    bar->setMovable(false);
    bar->addWidget(m_bar);
    addToolBar(Qt::TopToolBarArea, bar);
    connect(m_bar, &RunBar::endWanted, this, &TrainerDesk::endWanted);
    connect(m_bar, &RunBar::goBackWanted, this, &TrainerDesk::goBackWanted);
    connect(m_bar, &RunBar::consoleWanted, this, &TrainerDesk::consoleWanted);
    addChartTools();
    addViews(stage);
    addPanels();

    connect(m_frames, &QTimer::timeout, this, &TrainerDesk::drawViews);
    connect(m_beat, &QTimer::timeout, this, &TrainerDesk::refresh);
    m_frames->start(kFrame_ms);
    m_beat->start(kBeat_ms);
    refresh();
}

TrainerDesk::~TrainerDesk() = default;

void TrainerDesk::addChartTools() {
    auto* const bar = new QToolBar(tr("Chart"), this);
    bar->setObjectName(QStringLiteral("chart-bar"));
    addToolBarBreak();
    addToolBar(Qt::TopToolBarArea, bar);
    const auto add = [&](const QString& text, const QString& tip, auto&& work) {
        QAction* const action = bar->addAction(text, this, work);
        action->setToolTip(tip);
        return action;
    };
    add(tr("Whole area"), tr("Show all of the chart"), [this] { m_chart->fitArea(); });
    QAction* const follow = bar->addAction(tr("Follow ship"));
    follow->setCheckable(true);
    follow->setToolTip(tr("Keep the own ship in the middle (Home)"));
    connect(follow, &QAction::toggled, m_chart, &ChartWidget::follow);
    connect(m_chart, &ChartWidget::followingChanged, follow, &QAction::setChecked);
    QAction* const headUp = bar->addAction(tr("Head up"));
    headUp->setCheckable(true);
    headUp->setToolTip(tr("The own ship's heading is up, not north"));
    connect(headUp, &QAction::toggled, m_chart, &ChartWidget::setHeadUp);
    bar->addSeparator();
    QAction* const range = bar->addAction(tr("Range and bearing"));
    range->setCheckable(true);
    range->setToolTip(tr("Drag a line on the chart (Esc ends)"));
    connect(range, &QAction::toggled, this, [this](bool on) {
        m_chart->chooseTool(on ? ChartTools::Tool::RangeBearing : ChartTools::Tool::None);
    });
    connect(m_chart, &ChartWidget::toolChanged, range,
            [range](ChartTools::Tool tool) { range->setChecked(tool == ChartTools::Tool::RangeBearing); });
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

void TrainerDesk::addViews(render::Stage* stage) {
    auto* const dock = new QDockWidget(tr("Views"), this);
    dock->setObjectName(QStringLiteral("views"));
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    auto* const both = new QWidget(dock);
    auto* const layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    if (stage == nullptr) {
        auto* const none = new QLabel(tr("No 3D views: this machine has no OpenGL 3.3."), both);
        none->setAlignment(Qt::AlignCenter);
        layout->addWidget(none);
    } else {
        const auto& places = m_run.world()->area.places;
        for (std::size_t i = 0; i < 2; ++i) {
            m_views.push_back(new ViewportWidget(stage->addViewport(320, 180), both));
            for (const core::Place& place : places)
                if (place.kind == "entrance") m_views[i]->rig().shore = place.position;
            layout->addWidget(viewPanel(i), 1);
        }
    }
    dock->setWidget(both);
    addDockWidget(Qt::RightDockWidgetArea, dock);
}

void TrainerDesk::addPanel(const QString& title, const QString& name, QWidget* panel) {
    auto* const dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    dock->setWidget(scrolled(panel));
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    auto* const mission = findChild<QDockWidget*>(QStringLiteral("mission"));
    if (mission != nullptr && mission != dock) tabifyDockWidget(mission, dock);
}

void TrainerDesk::addPanels() {
    addPanel(tr("Mission"), QStringLiteral("mission"), m_mission);
    addPanel(tr("Events"), QStringLiteral("events"), m_events);
    if (!m_run.world()->ships.empty()) {
        m_instruments = new Instruments(*m_run.world(), 0, this);
        m_helm = new HelmPanel(m_run, 0, this);
        addPanel(tr("Own ship"), QStringLiteral("instruments"), m_instruments);
        addPanel(tr("Helm"), QStringLiteral("helm"), m_helm);
        auto* const ship = findChild<QDockWidget*>(QStringLiteral("instruments"));
        addDockWidget(Qt::LeftDockWidgetArea, ship);  // below the others
        tabifyDockWidget(ship, findChild<QDockWidget*>(QStringLiteral("helm")));
        ship->raise();
    }
    findChild<QDockWidget*>(QStringLiteral("mission"))->raise();
}

void TrainerDesk::showSailed(std::vector<ChartTrackPoint> track) {
    m_chart->setTracks({ChartTrack{std::move(track), true}});
}

void TrainerDesk::setMayGoBack(bool may) { m_bar->setMayGoBack(may); }

void TrainerDesk::setColours(PaletteName name) { m_chart->setColours(name); }

/// Sizes are known only now: room for the panels by the width of the desk, and the chart at the route.
void TrainerDesk::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_laidOut, true)) return;
    QTimer::singleShot(0, this, [this] {
        resizeDocks({findChild<QDockWidget*>(QStringLiteral("mission")),
                     findChild<QDockWidget*>(QStringLiteral("views"))},
                    {std::clamp(width() / 5, kLeftLeast_px, 420), std::clamp(width() / 3, 300, 760)},
                    Qt::Horizontal);
        chart::Extent extent;
        for (const auto& waypoint : m_run.world()->route.waypoints) extent.include(waypoint.position);
        for (const auto& ship : m_run.latest()->ships) extent.include(ship.motion.position());
        if (extent.empty) return;
        const core::NorthEast margin{0.12 * extent.height_m() + 200.0, 0.12 * extent.width_m() + 200.0};
        extent.include(extent.southWest - margin);
        extent.include(extent.northEast + margin);
        m_chart->fitTo(extent);
    });
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
    if (m_instruments != nullptr) m_instruments->show(*now);
    if (m_helm != nullptr) m_helm->refresh();
    if (m_run.over()) {  // no order is carried out any more
        m_events->setEnabled(false);
        if (m_helm != nullptr) m_helm->setEnabled(false);
    }
    refreshChart(*now);
}

void TrainerDesk::refreshChart(const core::Snapshot& now) {
    const core::World& world = *m_run.world();
    m_chart->setOwnShips(ownShipsOf(world, now));
    m_chart->setTargets(targetsOf(world, now));
    m_chart->setAnchors(anchorsOf(world, now));
    const std::int64_t second = now.time().us / 1'000'000;
    if (now.ships.empty() || second == m_trackedTo_s) return;
    m_trackedTo_s = second;
    m_chart->extendTrack(0, {now.time().seconds(), now.ships[0].motion.position()});
    if (second - m_predictedAt_s >= 2) predict();
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
