#include "app/replay/ReplayRun.h"

#include <algorithm>

#include "app/run/GradeRecording.h"
#include "core/exercise/Replay.h"
#include "render/link/SteadyClock.h"

namespace sagara::replay {
namespace {

std::int64_t now_us() { return link::steadyClock_us(); }
std::int64_t tickOf(core::SimTime time) { return time.us / core::kTick_us; }

run::RunSummary summaryOf(const Film& film) {
    const core::Mission& mission = film.world->mission;
    if (film.exact) {
        const auto last = core::stateAt(*film.world, film.recording, film.endTick());
        if (last) {
            run::RunSummary summary = run::summarise(*film.world, mission, last->assessment,
                                                     run::assessmentEvents(film.recording.events));
            summary.gradedFrom = "the run itself, to the bit";
            return summary;
        }
    }
    return run::gradeRecording(*film.world, film.recording, film.endTick());
}

}  // namespace

ui::ReplayResult resultOf(const Film& film) {
    const run::RunSummary summary = summaryOf(film);
    ui::ReplayResult result{
        summary.passed,    summary.whyNot, summary.score, film.world->mission.passScore, {}, {},
        summary.gradedFrom};
    for (const auto& task : summary.tasks) result.tasks.push_back({task.title, task.done, task.time_s});
    for (const auto& loss : summary.losses)
        result.losses.push_back({loss.title, loss.quantity, loss.unit, loss.time_s, loss.value, loss.limit,
                                 loss.points, loss.fails});
    return result;
}

ReplayRun::ReplayRun(std::shared_ptr<const Film> film, ui::ReplayResult result)
    : m_film(std::move(film)),
      m_result(std::move(result)),
      m_clock(core::timeOfTick(m_film->beginTick()), core::timeOfTick(m_film->endTick())),
      m_track(m_film) {
    if (!m_film->exact) return;
    m_exact = std::make_unique<ExactPlayer>(m_film);
    m_orders = std::make_unique<OrderScan>(m_film);
}

std::shared_ptr<const ui::ReplayOrders> ReplayRun::orders() const {
    return m_orders ? m_orders->result() : nullptr;
}

std::string ReplayRun::remark() const {
    std::string text = m_film->remark;
    const std::string trouble = m_exact ? m_exact->trouble() : std::string();
    if (trouble.empty()) return text;
    if (!text.empty()) text += " ";
    return text + "The run cannot be run again (" + trouble + "): its recorded track is shown.";
}

void ReplayRun::wish() {
    if (m_exact) m_exact->want(tickOf(now()), playing() ? m_clock.rate() : 0.0);
}

ui::Replay::Picture ReplayRun::toDraw() {
    wish();
    const core::SimTime time = now();
    if (m_exact) {
        if (auto exact = m_exact->at(time)) return {time, std::move(*exact), true};
    }
    return {time, m_track.at(time), false};
}

core::SimTime ReplayRun::now() const { return m_clock.at(now_us()); }
bool ReplayRun::playing() const { return m_clock.playing(now_us()); }

void ReplayRun::play() {
    m_clock.play(now_us());
    wish();
}

void ReplayRun::pause() {
    m_clock.pause(now_us());
    wish();
}

void ReplayRun::setRate(double times) {
    m_clock.setRate(std::clamp(times, ui::kSlowestReplay, ui::kFastestReplay), now_us());
    wish();
}

void ReplayRun::seek(core::SimTime time) {
    m_clock.seek(time, now_us());
    wish();
}

std::optional<core::State> ReplayRun::state() const {
    return m_exact && !playing() ? m_exact->stateAt(tickOf(now())) : std::nullopt;
}

}  // namespace sagara::replay
