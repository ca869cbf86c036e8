#include "ui/trainee/ChartPage.h"

#include <QAction>
#include <QFutureWatcher>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>
#include <utility>

#include "core/exercise/Prediction.h"
#include "ui/run/RunTexts.h"
#include "ui/trainee/AisTargets.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/PreparedExercise.h"
#include "ui/widgets/PrintChart.h"
#include "ui/widgets/SnapshotScene.h"

namespace sagara::ui::console {
namespace {

constexpr double kPrediction_s = 360.0, kPredictionStep_s = 10.0;

}  // namespace

ChartPage::ChartPage(ExerciseRun& run, const ConsoleOptions& options, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_ship(options.ship),
      m_prediction(options.prediction),
      m_prepared(options.chart ? options.chart : prepareChart(run.world(), options.ship)),
      m_chart(new ChartWidget(this)) {
    const core::World& world = *run.world();
    m_chart->setObjectName(QStringLiteral("chart"));
    m_chart->setChart(m_prepared);
    m_chart->setRoute(world.route);
    m_chart->setTracks({ChartTrack{}});
    m_overlay = new BearingOverlay(*m_chart);
    auto* const bar = new QToolBar(this);
    addTools(*bar);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(m_chart, 1);
}

void ChartPage::addTools(QToolBar& bar) {
    const auto check = [&](const QString& text, const QString& tip) {
        QAction* const action = bar.addAction(text);
        action->setCheckable(true);
        action->setToolTip(tip);
        return action;
    };
    bar.addAction(tr("Whole area"), m_chart, &ChartWidget::fitArea)->setToolTip(tr("Show all of the chart"));
    QAction* const follow = check(tr("Follow"), tr("Keep the own ship in the middle"));
    connect(follow, &QAction::toggled, m_chart, &ChartWidget::follow);
    connect(m_chart, &ChartWidget::followingChanged, follow, &QAction::setChecked);
    connect(check(tr("Head up"), tr("The own ship's heading is up, not north")), &QAction::toggled, m_chart,
            &ChartWidget::setHeadUp);
    const auto tool = [&](const QString& text, const QString& tip, ChartTools::Tool which) {
        QAction* const action = check(text, tip);
        connect(action, &QAction::toggled, this, [this, which](bool on) {
            if (on || m_chart->tool() == which) m_chart->chooseTool(on ? which : ChartTools::Tool::None);
        });
        connect(m_chart, &ChartWidget::toolChanged, action,
                [action, which](ChartTools::Tool now) { action->setChecked(now == which); });
    };
    tool(tr("Range"), tr("Range and bearing: drag a line on the chart; Esc ends"),
         ChartTools::Tool::RangeBearing);
    tool(tr("Rule"), tr("Parallel rule: lay it along, drag it over; Esc ends"),
         ChartTools::Tool::ParallelRule);
    QAction* const print = bar.addAction(tr("Print..."), this, &ChartPage::print);
    print->setObjectName(QStringLiteral("chart-print"));
    print->setToolTip(tr(
        "What the chart shows now on paper or as PDF, with compass rose, graticule and scale, to plot on"));
}

void ChartPage::setColours(PaletteName name) { m_chart->setColours(name); }

/// The size is known only now: own ship and route in sight.
void ChartPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (std::exchange(m_laidOut, true)) return;
    QTimer::singleShot(0, this, [this] {
        chart::Extent extent;
        for (const auto& waypoint : m_run.world()->route.waypoints) extent.include(waypoint.position);
        extent.include(m_run.latest()->ships[m_ship].motion.position());
        const core::NorthEast margin{0.12 * extent.height_m() + 300.0, 0.12 * extent.width_m() + 300.0};
        extent.include(extent.southWest - margin);
        extent.include(extent.northEast + margin);
        m_chart->fitTo(extent);
    });
}

void ChartPage::show(const core::Snapshot& now) {
    const core::World& world = *m_run.world();
    m_chart->setOwnShips({ownShipsOf(world, now)[m_ship]});
    m_chart->setTargets(aisTargetsOf(world, now, m_ship));
    m_chart->setAnchors(now.ships.size() == 1 ? anchorsOf(world, now) : std::vector<ChartAnchor>{});
    const std::int64_t second = now.time().us / 1'000'000;
    if (second == m_trackedTo_s) return;
    if (second < m_trackedTo_s) m_chart->setTracks({ChartTrack{}});  // gone back to a snapshot
    m_trackedTo_s = second;
    m_chart->extendTrack(0, {now.time().seconds(), now.ships[m_ship].motion.position()});
    if (m_prediction && std::abs(second - m_predictedAt_s) >= 2) predict();
}

/// Takes some 30 ms, so aside.
void ChartPage::predict() {
    m_predictedAt_s = m_trackedTo_s;
    auto* const watcher = new QFutureWatcher<std::vector<core::PredictedPose>>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] {
        m_chart->setPredictions({predictionOf(*m_run.world(), m_ship, watcher->result())});
        watcher->deleteLater();
    });
    watcher->setFuture(QtConcurrent::run([world = m_run.world(), state = m_run.state(), ship = m_ship] {
        return core::predict(*world, state, ship, kPrediction_s, kPredictionStep_s);
    }));
}

void ChartPage::print() {
    const core::World& world = *m_run.world();
    askAndPrint(this, sheetOf(*m_chart, QString::fromStdString(world.scenarioName),
                              tr("%1, %2 local")
                                  .arg(QString::fromStdString(world.area.name),
                                       localTime(world, m_run.latest()->time()))));
}

}  // namespace sagara::ui::console
