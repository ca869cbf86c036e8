#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/replay/Film.h"
#include "core/exercise/Session.h"
#include "core/exercise/Snapshot.h"

namespace sagara::replay {

/// Runs a recorded exercise again in a thread of its own, to the bit, about the moment that is looked at:
/// from the last stored state before it, or on from where it is. Every call may come from any thread and
/// none waits for the run.
class ExactPlayer {
public:
    explicit ExactPlayer(std::shared_ptr<const Film> film);
    ~ExactPlayer();
    ExactPlayer(const ExactPlayer&) = delete;
    ExactPlayer& operator=(const ExactPlayer&) = delete;

    /// The tick looked at now, and how fast that moves on: 0 for standing, then its state is made.
    void want(std::int64_t tick, double rate);
    /// What is seen then; none where the run is not there yet.
    std::optional<core::Snapshot> at(core::SimTime time) const;
    std::optional<core::State> stateAt(std::int64_t tick) const;
    /// Why it cannot go on; empty while it can.
    std::string trouble() const;

private:
    struct Wish {
        std::int64_t tick = 0;
        double rate = 0.0;
    };
    void run();
    bool reached(const Wish& wish) const;  ///< under the lock
    std::int64_t lead_ticks(const Wish& wish) const;
    bool begin(std::int64_t tick);  ///< at the last stored state before; false: it cannot be read
    void advanceTo(const Wish& wish);
    void publish(bool withState);

    const std::shared_ptr<const Film> m_film;
    std::unique_ptr<core::Session> m_session;  ///< of the thread
    mutable std::mutex m_mutex;                ///< of what follows
    std::condition_variable m_wake;
    std::deque<std::shared_ptr<const core::Snapshot>> m_trail;  ///< in the order of time
    std::optional<core::State> m_state;                         ///< of the session, when it stands
    Wish m_wish;
    std::uint64_t m_wishes = 0;  ///< counts them
    std::string m_trouble;
    bool m_stop = false;
    std::thread m_thread;
};

}  // namespace sagara::replay
