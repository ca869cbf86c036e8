#include "ui/debrief/DebriefDesk.h"

#include <QAction>
#include <QFutureWatcher>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/debrief/ComparePanel.h"
#include "ui/debrief/PlotStack.h"
#include "ui/debrief/SailPanel.h"
#include "ui/debrief/ScorePanel.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/debrief/Timeline.h"
#include "ui/debrief/TransportBar.h"
#include "ui/debrief/ViewsPanel.h"
#include "ui/theme/ThemeColours.h"
#include "ui/trainer/Instruments.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/SnapshotScene.h"

namespace sagara::ui {
namespace {

constexpr int kPlot_px = 84;
constexpr int kIdleEvery = 10;  ///< frames of a picture that stands
constexpr core::SimTime kMarkSlack{500'000};
constexpr std::int64_t kTargetWayEvery_ticks = 5 * core::kTicksPerSecond;

/// Where each target was, five seconds apart.
std::vector<ChartTrack> targetWays(const std::vector<core::TrackSample>& track) {
    std::vector<ChartTrack> ways;
    for (const core::TrackSample& sample : track) {
        if (sample.tick % kTargetWayEvery_ticks != 0) continue;
        if (ways.size() < sample.targets.size()) ways.resize(sample.targets.size(), ChartTrack{{}, false});
        for (std::size_t i = 0; i < sample.targets.size(); ++i)
            if (sample.targets[i].present)
                ways[i].points.push_back(
                    {core::timeOfTick(sample.tick).seconds(), sample.targets[i].position});
    }
    return ways;
}

/// The part of a track up to a time.
ChartTrack until(const ChartTrack& whole, double time_s) {
    const auto end = std::partition_point(whole.points.begin(), whole.points.end(),
                                          [time_s](const auto& p) { return p.time_s <= time_s; });
    return {{whole.points.begin(), end}, whole.ownShip};
}

}  // namespace

DebriefDesk::~DebriefDesk() { delete m_sail; }  // before the branch it sails

void DebriefDesk::setColours(PaletteName name) {
    m_colours = name;
    const ThemeColours& c = themeColours(name);
    m_chart->setColours(name);
    m_overlay->setColours(name);
    m_timeline->setColours(name);
    m_plots->setColours(name);
    m_score->setColours(name);
    m_transport->setColours(name);
    m_compare->setColours(name);
    m_remark->setStyleSheet(
        QStringLiteral("background: %1; color: %2;").arg(c.caution.name(), c.onCaution.name()));
    m_notice->setStyleSheet(QStringLiteral("background: %1; color: %2; border: 1px solid %3;")
                                .arg(c.section.name(), c.text.name(), c.border.name()));
}

core::SimTime DebriefDesk::shown() const {
    if (m_mode == Mode::Sailing) return m_branch->latest()->time();
    return m_beyond ? *m_beyond : m_replay->now();
}

void DebriefDesk::tell(const QString& words) {
    m_notice->setText(words);
    m_notice->setVisible(!words.isEmpty());
}

// moving in time

void DebriefDesk::goTo(core::SimTime time) {
    if (m_mode == Mode::Sailing) return;
    m_sailWanted = false;
    m_beyond = m_mode == Mode::Comparing && time > m_replay->end() ? std::optional(time) : std::nullopt;
    if (m_beyond) m_replay->pause();
    m_replay->seek(time);
    refresh();
}

void DebriefDesk::step(double seconds) {
    m_replay->pause();
    const auto by_us = static_cast<std::int64_t>(std::llround(1e6 * seconds));
    goTo({std::clamp(shown().us + by_us, m_axis->begin().us, m_axis->end().us)});
}

void DebriefDesk::goToMark(int direction) {
    const core::SimTime now = shown();
    const auto& marks = m_timeline->marks();
    const DebriefMark* found = nullptr;
    for (const DebriefMark& mark : marks) {
        if (direction > 0 && mark.time.us > now.us + kMarkSlack.us / 10) {
            found = &mark;
            break;
        }
        if (direction < 0 && mark.time.us < now.us - kMarkSlack.us / 10) found = &mark;
    }
    if (found != nullptr) return goTo(found->time);
    goTo(direction > 0 ? m_replay->end() : m_replay->begin());
}

void DebriefDesk::togglePlay() {
    if (m_mode == Mode::Sailing) return;
    if (m_replay->playing()) {
        m_replay->pause();
    } else {
        if (m_replay->now() >= m_replay->end()) m_replay->seek(m_replay->begin());
        m_beyond.reset();
        m_sailWanted = false;
        m_replay->play();
    }
    refresh();
}

void DebriefDesk::keyPressEvent(QKeyEvent* event) {
    const bool ctrl = event->modifiers() & Qt::ControlModifier;
    const double step_s = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
    switch (event->key()) {
        case Qt::Key_Space:
            return togglePlay();
        case Qt::Key_Left:
            return ctrl ? goToMark(-1) : step(-step_s);
        case Qt::Key_Right:
            return ctrl ? goToMark(1) : step(step_s);
        case Qt::Key_Home:
            return goTo(m_axis->begin());
        case Qt::Key_End:
            return goTo(m_axis->end());
        case Qt::Key_N:
            if (m_ports.addNote) return Q_EMIT m_transport->noteWanted();
            break;
        case Qt::Key_Escape:
            if (m_noteBar->isVisible()) return addNote(false);
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

// notes and marks

void DebriefDesk::addNote(bool keep) {
    const std::string text = m_noteText->text().trimmed().toStdString();
    if (keep && text.empty()) return m_noteText->setFocus();
    m_noteBar->hide();
    m_noteText->clear();
    setFocus();
    if (!keep) return;
    const auto trouble = m_ports.addNote({m_noteAt, text});
    tell(trouble ? tr("The note could not be kept: %1").arg(QString::fromStdString(*trouble)) : QString());
    readMarks();
}

void DebriefDesk::readMarks() {
    const std::vector<DebriefMark> marks =
        marksOf(*m_replay, m_ports.notes ? m_ports.notes() : std::vector<DebriefNote>());
    m_timeline->setMarks(marks);
    m_overlay->setMarks(marks);
    m_plots->setMarks(marks);
    m_score->setNotes(marks);
}

/// Orders come some time after the track: they are worked out aside.
void DebriefDesk::takeOrders() {
    if (m_haveOrders) return;
    const auto orders = m_replay->orders();
    if (!orders) return;
    m_haveOrders = true;
    auto* const watcher = new QFutureWatcher<std::shared_ptr<const PlotData>>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] {
        m_plotData = watcher->result();
        m_plots->setData(m_plotData);
        watcher->deleteLater();
    });
    // a copy: the page may go before it is done
    watcher->setFuture(QtConcurrent::run([world = m_replay->world(), track = m_replay->track(), orders] {
        return std::make_shared<const PlotData>(plotData(*world, track, orders.get()));
    }));
}

// showing

void DebriefDesk::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_ports.stage) m_views->setStage(m_ports.stage(m_replay->world()), m_replay->world());
    m_frames->start();
    m_beat->start();
    if (std::exchange(m_laidOut, true)) return;
    QTimer::singleShot(0, this, [this] {
        layOut();
        fitRun();
        setFocus();
    });
}

/// Room by the size of the window, and by what is done: a table of two runs is wide.
void DebriefDesk::layOut() {
    const bool comparing = m_mode == Mode::Comparing;
    const int side = comparing ? std::clamp(width() / 3, 400, 620) : std::clamp(width() / 5, 335, 420);
    const int views = comparing ? std::clamp(width() / 5, 240, 600) : std::clamp(width() / 3, 300, 760);
    m_across->setSizes({side, width() - side - views, views});
    if (std::exchange(m_divided, true)) return;
    const int lower = std::clamp(45 * height() / 100, 320, 500);
    m_down->setSizes({height() - lower, lower});
    if (m_plotsGiven) return;
    const int room = (lower - m_transport->height() - m_timeline->height() - 8) / kPlot_px;
    for (const PlotKind kind : {PlotKind::Heading, PlotKind::UnderKeel})
        if (static_cast<int>(m_plots->shown().size()) < room)
            findChild<QAction*>(QStringLiteral("plot-%1").arg(static_cast<int>(kind)))->setChecked(true);
}

void DebriefDesk::hideEvent(QHideEvent* event) {
    m_frames->stop();
    m_beat->stop();
    m_replay->pause();
    if (m_branch) m_branch->freeze();
    QWidget::hideEvent(event);
}

/// All of the run, or where the two that are compared differ.
void DebriefDesk::fitRun() {
    chart::Extent extent;
    double from_s = 0.0, to_s = 1e12;
    if (m_mode != Mode::Replay && m_branch) {
        from_s = m_branch->from().seconds();
        to_s = m_branch->latest()->time().seconds() + 1.0;
    }
    for (const auto& point : m_way)
        if (point.time_s >= from_s && point.time_s <= to_s) extent.include(point.position);
    for (const core::TrackSample& sample : m_branchTrack)
        if (!sample.ships.empty()) extent.include(sample.ships[0].motion.position());
    if (extent.empty) return m_chart->fitArea();
    m_chart->follow(false);
    const core::NorthEast margin{0.08 * extent.height_m() + 150.0, 0.08 * extent.width_m() + 150.0};
    extent.include(extent.southWest - margin);
    extent.include(extent.northEast + margin);
    m_chart->fitTo(extent);
}

const core::Snapshot& DebriefDesk::takePicture() {
    if (m_mode == Mode::Sailing) {
        ExerciseRun::Picture picture = m_branch->toDraw();
        m_picture = {picture.time, std::move(picture.snapshot), true};
    } else {
        m_picture = m_replay->toDraw();
    }
    return m_picture.snapshot;
}

void DebriefDesk::drawViews() {
    const core::SimTime before = m_picture.time;
    const bool exactBefore = m_picture.exact;
    takePicture();
    const bool stands = m_picture.time == before && m_picture.exact == exactBefore;
    const bool touched = m_views->underMouse() || m_views->isAncestorOf(QWidget::focusWidget());
    m_idleFrames = stands && !touched ? m_idleFrames + 1 : 0;
    if (m_idleFrames > 4 && m_idleFrames % kIdleEvery != 0) return;
    m_views->draw(m_picture.snapshot, m_picture.time);
}

void DebriefDesk::refresh() {
    if (m_sailWanted) startBranchWhenReady();
    const core::Snapshot& now = takePicture();
    if (m_mode != Mode::Sailing) m_exactShown = m_picture.exact;
    const QString remark = QString::fromStdString(m_replay->remark());
    m_remark->setText(remark);
    m_remark->setVisible(!remark.isEmpty());
    if (m_mode == Mode::Sailing) {
        m_axis->setWhole(m_replay->begin(), std::max(m_replay->end(), now.time()));
        m_sail->refresh();
        refreshBranchPlots();
    }
    m_axis->setCursor(shown());
    m_transport->refresh(m_mode == Mode::Sailing, m_exactShown);
    m_score->setNow(shown());
    if (m_instruments != nullptr) m_instruments->show(now);
    const bool changed = m_chartShows != std::pair(m_picture.time.us, m_picture.exact);
    if (changed || m_trackedTo_s < 0) refreshChart(now);
    m_chartShows = {m_picture.time.us, m_picture.exact};
    takeOrders();
}

void DebriefDesk::refreshChart(const core::Snapshot& now) {
    const core::World& world = *m_replay->world();
    m_chart->setOwnShips(ownShipsOf(world, now));
    m_chart->setTargets(targetsOf(world, now));
    m_chart->setAnchors(anchorsOf(world, now));
    refreshGhost();
    const std::int64_t second = now.time().us / 1'000'000;
    if (second == m_trackedTo_s) return;
    m_trackedTo_s = second;
    if (m_targetWays.empty()) m_targetWays = targetWays(m_replay->track());
    ChartTrack own;
    if (m_mode == Mode::Replay) {
        for (const auto& point : m_way) {
            if (point.time_s > static_cast<double>(second)) break;
            own.points.push_back({point.time_s, point.position});
        }
    }
    std::vector<ChartTrack> tracks{std::move(own)};
    for (const ChartTrack& way : m_targetWays) tracks.push_back(until(way, static_cast<double>(second)));
    m_chart->setTracks(std::move(tracks));
}

/// The whole way of the recording, and that of what if.
void DebriefDesk::refreshTracks() {
    OverlayTrack sailed;
    sailed.points = m_way;
    sailed.colour = 0;
    sailed.faint = m_mode != Mode::Comparing;
    sailed.ticks = m_mode == Mode::Comparing;
    std::vector<OverlayTrack> tracks{std::move(sailed)};
    if (m_branch) {
        OverlayTrack whatIf;
        whatIf.points = overlayPoints(m_branchTrack);
        whatIf.colour = 1;
        whatIf.ticks = true;
        tracks.push_back(std::move(whatIf));
    }
    m_overlay->setTracks(std::move(tracks));
    m_trackedTo_s = -1;
}

}  // namespace sagara::ui
