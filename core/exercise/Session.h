#pragma once

#include <memory>
#include <vector>

#include "core/exercise/Event.h"
#include "core/exercise/Recording.h"

namespace sagara::core {

/// A run in progress: the state, the queue of commands and the recorder behind it. Everything that drives an
/// exercise goes through here, and nothing but this calls advance on it. No clock: the owner decides when the
/// next tick is due.
class Session {
public:
    /// `world`: built for sailing. `planned`: commands with their ticks, in order. `recorder` may be null and
    /// outlives the session.
    Session(std::shared_ptr<const World> world, State state, std::vector<Command> planned,
            RecordingWriter* recorder);

    /// An order from outside; it is carried out in the next tick.
    void give(std::uint8_t ship, Order order);

    /// One tick: the planned commands of it first, then those given since the last.
    std::vector<Event> step();

    const World& world() const { return *m_world; }
    const State& state() const { return m_state; }
    bool over() const { return m_state.finished || m_state.stopped; }

private:
    std::shared_ptr<const World> m_world;
    State m_state;
    std::vector<Command> m_planned;
    std::size_t m_nextPlanned = 0;
    std::vector<Command> m_given;
    std::vector<Command> m_now;
    RecordingWriter* m_recorder;
};

/// The exercise after the scripted pilot has sailed it so long from its start, or to its end.
State sailedByPilot(std::shared_ptr<const World> world, int level, SimTime until);

}  // namespace sagara::core
