#include "app/live/LiveRun.h"

#include <algorithm>
#include <chrono>

#include "render/link/SteadyClock.h"

namespace sagara::live {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kMostLag = std::chrono::milliseconds(500);

std::shared_ptr<const core::Snapshot> snapshotOf(const core::World& world, const core::State& state) {
    return std::make_shared<const core::Snapshot>(core::view(world, state));
}

}  // namespace

LiveRun::LiveRun(std::shared_ptr<const core::World> world, core::State start,
                 std::vector<core::Command> planned, core::RecordingWriter* recorder,
                 std::vector<core::Event> past)
    : m_session(world, start, std::move(planned), recorder),
      m_world(std::move(world)),
      m_latest(snapshotOf(*m_world, start)),
      m_state(std::move(start)),
      m_events(std::move(past)) {
    m_trail.add(m_latest);
    m_over = m_session.over();
    m_thread = std::thread([this] { run(); });
}

LiveRun::~LiveRun() { stop(); }

void LiveRun::start() {
    {
        const std::lock_guard lock(m_mutex);
        m_running = !m_over;
    }
    m_wake.notify_all();
}

void LiveRun::freeze() {
    const std::lock_guard lock(m_mutex);
    m_running = false;
}

void LiveRun::setRate(double times) {
    const std::lock_guard lock(m_mutex);
    m_rate = std::clamp(times, 0.1, kFastestRate);
}

void LiveRun::stop() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
        m_running = false;
    }
    m_wake.notify_all();
    if (m_thread.joinable()) m_thread.join();
}

void LiveRun::waitToRun() {
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return m_running || m_stop; });
}

void LiveRun::run() {
    while (!m_stop) {
        waitToRun();
        auto due = Clock::now();
        while (m_running) {
            due += std::chrono::duration_cast<Clock::duration>(
                std::chrono::duration<double>(core::kTick_s / m_rate));
            std::this_thread::sleep_until(due);
            if (const auto lag = Clock::now() - due; lag > kMostLag) {
                due += lag;  // no burst to catch up: that would only make it worse
                m_lagged_s = m_lagged_s + m_rate * std::chrono::duration<double>(lag).count();
            }
            if (!m_running) break;
            if (!tick()) return;
        }
    }
}

/// False at the end of the exercise.
bool LiveRun::tick() {
    std::vector<std::pair<std::uint8_t, core::Order>> given;
    {
        const std::lock_guard lock(m_mutex);
        given.swap(m_given);
    }
    for (auto& [ship, order] : given) m_session.give(ship, std::move(order));
    const std::vector<core::Event> events = m_session.step();
    auto snapshot = snapshotOf(*m_world, m_session.state());

    const std::lock_guard lock(m_mutex);
    if (!given.empty() && m_given.empty()) m_carriedOut = snapshot->time();
    m_latest = snapshot;
    m_trail.add(std::move(snapshot));
    m_state = m_session.state();
    m_events.insert(m_events.end(), events.begin(), events.end());
    if (!m_session.over()) return true;
    m_over = true;
    m_running = false;
    return false;
}

void LiveRun::give(std::uint8_t ship, core::Order order) {
    const std::lock_guard lock(m_mutex);
    m_given.emplace_back(ship, std::move(order));
    m_carriedOut.reset();
}

std::optional<core::SimTime> LiveRun::carriedOut() const {
    const std::lock_guard lock(m_mutex);
    return m_carriedOut;
}

std::shared_ptr<const core::Snapshot> LiveRun::latest() const {
    const std::lock_guard lock(m_mutex);
    return m_latest;
}

core::State LiveRun::state() const {
    const std::lock_guard lock(m_mutex);
    return m_state;
}

std::vector<core::Event> LiveRun::eventsFrom(std::size_t index) const {
    const std::lock_guard lock(m_mutex);
    const auto from = m_events.begin() + static_cast<std::ptrdiff_t>(std::min(index, m_events.size()));
    return {from, m_events.end()};
}

wall::Moment LiveRun::toDraw(wall::FrameClock& clock) const {
    const std::lock_guard lock(m_mutex);
    clock.setRate(m_rate);
    const core::SimTime time = clock.at(link::steadyClock_us(), m_trail.newest());
    return {time, m_trail.at(time)};
}

}  // namespace sagara::live
