#include "SteppedRun.h"

#include <cmath>

#include "core/exercise/Advance.h"

namespace sagara::test {

SteppedRun::SteppedRun(std::shared_ptr<const core::World> world, int level)
    : m_world(std::move(world)),
      m_session(std::make_unique<core::Session>(m_world, core::startState(*m_world, level),
                                                std::vector<core::Command>{}, nullptr)),
      m_latest(std::make_shared<const core::Snapshot>(core::view(*m_world, m_session->state()))) {}

void SteppedRun::sail(double seconds) {
    const auto end = m_session->state().tick + std::llround(seconds * core::kTicksPerSecond);
    while (m_session->state().tick < end && !m_session->over()) {
        for (core::Event& event : m_session->step()) m_events.push_back(std::move(event));
    }
    m_latest = std::make_shared<const core::Snapshot>(core::view(*m_world, m_session->state()));
}

void SteppedRun::goBackTo(const core::State& state) {
    m_session = std::make_unique<core::Session>(m_world, state, std::vector<core::Command>{}, nullptr);
    std::erase_if(m_events, [&](const core::Event& e) { return e.tick >= state.tick; });
    m_latest = std::make_shared<const core::Snapshot>(core::view(*m_world, state));
}

std::vector<core::Event> SteppedRun::eventsFrom(std::size_t index) const {
    if (index >= m_events.size()) return {};
    return {m_events.begin() + static_cast<std::ptrdiff_t>(index), m_events.end()};
}

void SteppedRun::give(std::uint8_t ship, core::Order order) {
    m_given.push_back(order);
    m_session->give(ship, std::move(order));
}

}  // namespace sagara::test
