// "What if": the part of the debriefing that sails anew from a second of the recording and compares.
#include <QLabel>
#include <QMessageBox>
#include <QStackedWidget>
#include <utility>

#include "ui/debrief/ComparePanel.h"
#include "ui/debrief/Comparison.h"
#include "ui/debrief/DebriefDesk.h"
#include "ui/debrief/PlotStack.h"
#include "ui/debrief/SailPanel.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/debrief/Timeline.h"
#include "ui/debrief/TransportBar.h"
#include "ui/run/RunTexts.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

constexpr qint64 kPlotEvery_ms = 1000;
constexpr double kAround_m = 900.0;  ///< of the ship, shown when she is taken

}  // namespace

bool DebriefDesk::mayLeave() {
    if (!m_branch || m_branch->finished()) return true;
    m_branch->freeze();
    QMessageBox box(QMessageBox::Question, tr("What if"),
                    tr("The run sailed from %1 has not been ended. Leave? It is filed as it stands.")
                        .arg(elapsed(m_branch->from())),
                    QMessageBox::Yes | QMessageBox::No, this);
    box.setObjectName(QStringLiteral("leave-branch"));
    return box.exec() == QMessageBox::Yes;
}

void DebriefDesk::sailFromHere() {
    if (m_branch || !m_replay->exact() || !m_ports.branch) return;
    m_replay->pause();
    m_replay->seek({m_replay->now().us / 1'000'000 * 1'000'000});
    m_sailWanted = true;  // the state of that second may have to be worked out
    refresh();
}

void DebriefDesk::startBranchWhenReady() {
    if (!m_replay->exact()) {
        m_sailWanted = false;
        return tell(tr("Nothing can be sailed from this recording."));
    }
    auto state = m_replay->state();
    if (!state) return;
    m_sailWanted = false;
    if (state->finished || state->stopped)
        return tell(tr("The exercise was over then: go to an earlier moment to sail from."));
    auto branch = m_ports.branch(*m_replay, std::move(*state));
    if (!branch) return tell(tr("The run cannot be sailed: %1").arg(QString::fromStdString(branch.error())));
    m_branch = std::move(branch).value();
    m_sail = new SailPanel(*m_branch, this);
    m_left->addWidget(m_sail);
    connect(m_sail, &SailPanel::compareWanted, this, &DebriefDesk::compare);
    connect(m_sail, &SailPanel::endWanted, this, &DebriefDesk::endBranch, Qt::QueuedConnection);
    tell({});
    setMode(Mode::Sailing);
    showShip();
}

void DebriefDesk::setMode(Mode mode) {
    m_mode = mode;
    QWidget* const panels[] = {m_left->widget(0), m_sail, m_compare};
    m_left->setCurrentWidget(panels[static_cast<int>(mode)]);
    m_transport->setEnabled(mode != Mode::Sailing);
    m_timeline->setBranch(m_branch ? std::optional(m_branch->from()) : std::nullopt);
    m_beyond.reset();
    m_branchPlotted.invalidate();
    refreshTracks();
    refresh();
    layOut();
}

/// Who sails wants to see the water about the ship.
void DebriefDesk::showShip() {
    const auto now = m_branch->latest();
    if (now->ships.empty()) return;
    const core::NorthEast at = now->ships[0].motion.position(), margin{kAround_m, kAround_m};
    chart::Extent extent;
    extent.include(at - margin);
    extent.include(at + margin);
    m_chart->fitTo(extent);
    m_chart->follow(true);
}

void DebriefDesk::refreshBranchPlots() {
    if (m_branchPlotted.isValid() && m_branchPlotted.elapsed() < kPlotEvery_ms) return;
    m_branchPlotted.start();
    m_branchTrack = m_branch->track();
    m_plots->setOther(std::make_shared<const PlotData>(plotData(*m_replay->world(), m_branchTrack, nullptr)));
    refreshTracks();
}

/// The same ship in the other run: the recorded one while what if is sailed, what if while both are compared.
void DebriefDesk::refreshGhost() {
    const core::World& world = *m_replay->world();
    if (m_mode == Mode::Replay || world.ships.empty()) return m_overlay->setShip(std::nullopt);
    const bool sailing = m_mode == Mode::Sailing;
    const auto& track = sailing ? m_replay->track() : m_branchTrack;
    const core::TrackSample* const sample = sampleAt(track, shown());
    if (sample == nullptr || sample->ships.empty() || core::timeOfTick(track.front().tick) > shown())
        return m_overlay->setShip(std::nullopt);
    const auto& hull = world.ships[0]->vessel.hull;
    m_overlay->setShip(OverlayShip{
        sample->ships[0].motion.position(), sample->ships[0].motion.heading_rad, hull.lengthOverall_m,
        hull.beam_m, sailing ? tr("as recorded") : tr("what if"), sailing ? std::size_t{0} : std::size_t{1}});
}

void DebriefDesk::compare() {
    if (!m_branch) return;
    m_branch->freeze();
    m_branchTrack = m_branch->track();
    m_plots->setOther(std::make_shared<const PlotData>(plotData(*m_replay->world(), m_branchTrack, nullptr)));
    const core::SimTime from = m_branch->from();
    m_axis->setWhole(m_replay->begin(), std::max(m_replay->end(), m_branch->latest()->time()));
    showComparison();
    m_replay->seek(from);
    setMode(Mode::Comparing);
    fitRun();
}

void DebriefDesk::showComparison() {
    const core::World& world = *m_replay->world();
    const core::SimTime from = m_branch->from();
    std::vector<core::Event> events;
    for (const core::Event& e : m_replay->events())
        if (e.time() <= from) events.push_back(e);
    for (const core::Event& e : m_branch->eventsFrom(0)) events.push_back(e);
    const RunFigures sailed = figuresOf(world, m_replay->track(), m_replay->events(), from);
    const RunFigures whatIf = figuresOf(world, m_branchTrack, events, from);
    m_compare->show(
        comparisonOf(world, sailed, whatIf, differenceOf(m_replay->track(), m_branchTrack)),
        tr("What if, sailed from %1 to %2.").arg(elapsed(from), elapsed(m_branch->latest()->time())),
        !m_branch->over());
}

void DebriefDesk::sailOn() {
    if (!m_branch || m_branch->over()) return;
    m_replay->pause();
    setMode(Mode::Sailing);
    showShip();
}

void DebriefDesk::endBranch() {
    if (!m_branch) return;
    const core::SimTime from = m_branch->from();
    const QString outcome = QString::fromStdString(m_branch->finish());
    const QString trouble = QString::fromStdString(m_branch->trouble());
    tell(tr("The what-if run is kept as %1: %2. %3")
             .arg(QString::fromStdString(m_branch->recordingName()), outcome, trouble)
             .trimmed());
    m_left->setCurrentIndex(0);
    delete std::exchange(m_sail, nullptr);
    m_branch.reset();
    m_branchTrack.clear();
    m_plots->setOther(nullptr);
    m_axis->setWhole(m_replay->begin(), m_replay->end());
    m_axis->showAll();
    m_replay->seek(from);
    setMode(Mode::Replay);
    fitRun();
    setFocus();
}

}  // namespace sagara::ui
