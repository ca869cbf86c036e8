#include "app/run/LiveRun.h"

#include <chrono>
#include <cmath>

#include "render/link/SteadyClock.h"

namespace sagara::run {
namespace {

std::shared_ptr<const core::Snapshot> snapshotOf(const core::Session& session) {
    return std::make_shared<const core::Snapshot>(core::view(session.world(), session.state()));
}

}  // namespace

LiveRun::LiveRun(std::shared_ptr<const core::World> world, core::State start,
                 std::vector<core::Command> planned)
    : m_session(std::move(world), std::move(start), std::move(planned), nullptr) {
    m_trail.add(snapshotOf(m_session));
}

LiveRun::~LiveRun() { stop(); }

void LiveRun::start() {
    if (!m_thread.joinable()) m_thread = std::thread([this] { run(); });
}

void LiveRun::stop() {
    m_stop = true;
    if (m_thread.joinable()) m_thread.join();
}

void LiveRun::run() {
    using Clock = std::chrono::steady_clock;
    constexpr auto kTick = std::chrono::microseconds(core::kTick_us);
    constexpr auto kMostLag = std::chrono::milliseconds(500);
    for (auto due = Clock::now() + kTick; !m_stop && !m_session.over(); due += kTick) {
        std::this_thread::sleep_until(due);
        if (const auto lag = Clock::now() - due; lag > kMostLag) {
            due += lag;  // no burst to catch up: that would only make it worse
            m_lagged_s = m_lagged_s + std::chrono::duration<double>(lag).count();
        }
        const std::size_t given = takeOrders();
        (void)m_session.step();
        auto snapshot = snapshotOf(m_session);
        const std::lock_guard lock(m_mutex);
        if (given > 0 && m_given.empty()) m_carriedOut = snapshot->time();
        m_trail.add(std::move(snapshot));
    }
    m_over = m_session.over();
}

std::size_t LiveRun::takeOrders() {
    const std::lock_guard lock(m_mutex);
    const std::size_t count = m_given.size();
    for (auto& [ship, order] : m_given) m_session.give(ship, std::move(order));
    m_given.clear();
    return count;
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

wall::Moment LiveRun::now() {
    const std::lock_guard lock(m_mutex);
    const core::SimTime time = m_clock.at(link::steadyClock_us(), m_trail.newest());
    return {time, m_trail.at(time)};
}

SteppedRun::SteppedRun(std::shared_ptr<const core::World> world, core::State start,
                       std::vector<core::Command> planned, double frame_s)
    : m_session(std::move(world), std::move(start), std::move(planned), nullptr),
      m_frame_s(frame_s),
      m_first_us(m_session.state().time().us) {
    m_trail.add(snapshotOf(m_session));
}

wall::Moment SteppedRun::next() {
    if (m_started) ++m_frames;
    const core::SimTime time{m_first_us + static_cast<std::int64_t>(
                                              std::llround(1e6 * m_frame_s * static_cast<double>(m_frames)))};
    while (m_trail.newest() < time && !m_session.over()) {
        (void)m_session.step();
        m_trail.add(snapshotOf(m_session));
    }
    return {time, m_trail.at(time)};
}

}  // namespace sagara::run
