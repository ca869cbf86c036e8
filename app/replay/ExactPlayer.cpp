#include "app/replay/ExactPlayer.h"

#include <algorithm>

#include "core/exercise/Replay.h"
#include "render/link/Interpolate.h"

namespace sagara::replay {
namespace {

constexpr double kLead_s = 0.3;  ///< of the wall clock
constexpr std::size_t kLongestTrail = 256;

/// Ticks between two snapshots: pictures are drawn between them, and nobody sees more than fifty a second.
std::int64_t snapshotEvery_ticks(double rate) {
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(rate));
}

/// The last stored state not after the tick.
const core::Recording::StatePart& partBefore(const core::Recording& recording, std::int64_t tick) {
    const auto after = std::upper_bound(
        recording.states.begin(), recording.states.end(), tick,
        [](std::int64_t t, const core::Recording::StatePart& part) { return t < part.tick; });
    return after == recording.states.begin() ? *after : *(after - 1);
}

}  // namespace

ExactPlayer::ExactPlayer(std::shared_ptr<const Film> film) : m_film(std::move(film)) {
    m_wish.tick = m_film->beginTick();
    m_thread = std::thread([this] { run(); });
}

ExactPlayer::~ExactPlayer() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void ExactPlayer::want(std::int64_t tick, double rate) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_wish.tick == tick && m_wish.rate == rate) return;
        m_wish = {std::clamp(tick, m_film->beginTick(), m_film->endTick()), rate};
        ++m_wishes;
    }
    m_wake.notify_all();
}

std::optional<core::Snapshot> ExactPlayer::at(core::SimTime time) const {
    std::shared_ptr<const core::Snapshot> before, after;
    {
        const std::lock_guard lock(m_mutex);
        const auto later = std::find_if(m_trail.begin(), m_trail.end(),
                                        [time](const auto& snapshot) { return snapshot->time() >= time; });
        if (later == m_trail.end()) return std::nullopt;
        after = *later;
        if (after->time() == time) return *after;
        if (later == m_trail.begin()) return std::nullopt;
        before = *(later - 1);
    }
    return link::interpolated(*before, *after, time);
}

std::optional<core::State> ExactPlayer::stateAt(std::int64_t tick) const {
    const std::lock_guard lock(m_mutex);
    return m_state && m_state->tick == tick ? m_state : std::nullopt;
}

std::string ExactPlayer::trouble() const {
    const std::lock_guard lock(m_mutex);
    return m_trouble;
}

std::int64_t ExactPlayer::lead_ticks(const Wish& wish) const {
    return static_cast<std::int64_t>(wish.rate * kLead_s * static_cast<double>(core::kTicksPerSecond));
}

bool ExactPlayer::reached(const Wish& wish) const {
    if (!m_trouble.empty()) return true;
    if (m_trail.empty() || m_trail.front()->tick > wish.tick) return false;
    if (wish.rate == 0.0) return m_state && m_state->tick == wish.tick;
    return m_trail.back()->tick >= std::min(m_film->endTick(), wish.tick + lead_ticks(wish));
}

void ExactPlayer::run() {
    for (;;) {
        Wish wish;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_stop || !reached(m_wish); });
            if (m_stop) return;
            wish = m_wish;
        }
        advanceTo(wish);
    }
}

bool ExactPlayer::begin(std::int64_t tick) {
    auto state = core::readState(*m_film->world, partBefore(m_film->recording, tick));
    if (!state) {
        const std::lock_guard lock(m_mutex);
        m_trouble = state.error();
        return false;
    }
    m_session = std::make_unique<core::Session>(m_film->world, std::move(state).value(),
                                                m_film->recording.commands, nullptr);
    const std::lock_guard lock(m_mutex);
    m_trail.clear();
    m_state.reset();
    return true;
}

/// Goes towards what is wanted until that is reached or something else is wanted.
void ExactPlayer::advanceTo(const Wish& wish) {
    std::uint64_t wishes = 0;
    bool covered = false;
    {
        const std::lock_guard lock(m_mutex);
        wishes = m_wishes;
        covered = !m_trail.empty() && m_trail.front()->tick <= wish.tick;
    }
    const std::int64_t at = m_session ? m_session->state().tick : 0;
    const bool beyond = at > wish.tick && (wish.rate == 0.0 || !covered);
    const bool far = partBefore(m_film->recording, wish.tick).tick > at;
    if ((!m_session || beyond || far) && !begin(wish.tick)) return;

    const std::int64_t last = std::min(m_film->endTick(), wish.tick + lead_ticks(wish));
    const std::int64_t every = snapshotEvery_ticks(wish.rate);
    const auto seen = [&](std::int64_t tick) {
        return tick >= wish.tick - every && (tick % every == 0 || tick == wish.tick);
    };
    if (m_session->state().tick >= wish.tick - every) publish(false);
    while (m_session->state().tick < last && !m_session->state().stopped) {
        (void)m_session->step();
        if (seen(m_session->state().tick)) publish(false);
        const std::lock_guard lock(m_mutex);
        if (m_stop || m_wishes != wishes) return;
    }
    publish(wish.rate == 0.0);
    const std::lock_guard lock(m_mutex);
    if (m_trail.back()->tick < last)
        m_trouble = "it stops at " + std::to_string(m_trail.back()->tick / core::kTicksPerSecond) +
                    " s: a value was not a number";
}

void ExactPlayer::publish(bool withState) {
    const core::State& state = m_session->state();
    auto snapshot = std::make_shared<const core::Snapshot>(core::view(*m_film->world, state));
    const std::lock_guard lock(m_mutex);
    if (m_trail.empty() || m_trail.back()->tick < state.tick) m_trail.push_back(std::move(snapshot));
    while (m_trail.size() > kLongestTrail ||
           (m_trail.size() > 2 && m_trail[1]->tick < std::min(m_wish.tick, state.tick)))
        m_trail.pop_front();
    m_state = withState ? std::optional(state) : std::nullopt;
}

}  // namespace sagara::replay
