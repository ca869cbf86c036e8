#include "core/exercise/Session.h"

#include <cassert>

#include "core/exercise/Advance.h"

namespace sagara::core {

Session::Session(std::shared_ptr<const World> world, State state, std::vector<Command> planned,
                 RecordingWriter* recorder)
    : m_world(std::move(world)),
      m_state(std::move(state)),
      m_planned(std::move(planned)),
      m_recorder(recorder) {
    assert(m_world->use == WorldUse::Sail);
    while (m_nextPlanned < m_planned.size() && m_planned[m_nextPlanned].tick < m_state.tick) ++m_nextPlanned;
}

void Session::give(std::uint8_t ship, Order order) {
    m_given.push_back({m_state.tick, ship, std::move(order)});
}

std::vector<Event> Session::step() {
    m_now.clear();
    while (m_nextPlanned < m_planned.size() && m_planned[m_nextPlanned].tick == m_state.tick) {
        m_now.push_back(m_planned[m_nextPlanned++]);
    }
    m_now.insert(m_now.end(), m_given.begin(), m_given.end());
    m_given.clear();
    std::vector<Event> events = advance(*m_world, m_state, m_now);
    if (m_recorder) m_recorder->tick(*m_world, m_state, m_now, events);
    return events;
}

State sailedByPilot(std::shared_ptr<const World> world, int level, SimTime until) {
    State start = startState(*world, level);
    Session session(std::move(world), std::move(start), {{0, 0, PilotOrder{true}}}, nullptr);
    while (!session.over() && session.state().time() < until) (void)session.step();
    return session.state();
}

}  // namespace sagara::core
