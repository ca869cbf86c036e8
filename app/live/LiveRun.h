#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/exercise/Session.h"
#include "render/link/Interpolate.h"
#include "render/wall/FrameClock.h"
#include "render/wall/WallServer.h"

namespace sagara::live {

inline constexpr double kFastestRate = 20.0;  ///< seconds of the exercise to one of the wall clock

/// An exercise that runs in a thread of its own at the pace of the clock: started, frozen, hastened and given
/// orders from other threads, and what is to be seen of it now. Every call may come from any thread.
class LiveRun {
public:
    /// `recorder` may be null; it is used from the thread of the run and outlives it. `past`: what had
    /// happened before, of a run that is taken up again.
    LiveRun(std::shared_ptr<const core::World> world, core::State start, std::vector<core::Command> planned,
            core::RecordingWriter* recorder = nullptr, std::vector<core::Event> past = {});
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    /// Time runs from now on; until then, and while it is frozen, the same moment is shown.
    void start();
    void freeze();
    bool running() const { return m_running; }
    /// 1 is real time; kept within 0.1 and kFastestRate. A machine too slow for it falls behind (lagged_s).
    void setRate(double times);
    double rate() const { return m_rate; }
    /// Ends the thread; the exercise stays as it is. Nothing starts it again.
    void stop();

    /// An order from outside; it is carried out in the next tick. Of a frozen exercise, when it goes on.
    void give(std::uint8_t ship, core::Order order);
    /// The moment from which pictures show the orders given before the last call of `give` returned; none
    /// while they wait.
    std::optional<core::SimTime> carriedOut() const;

    bool over() const { return m_over; }
    double lagged_s() const { return m_lagged_s; }  ///< simulation time lost because the machine was too slow

    std::shared_ptr<const core::Snapshot> latest() const;
    core::State state() const;  ///< a copy, at a whole tick
    /// What has happened from the event of that index on.
    std::vector<core::Event> eventsFrom(std::size_t index) const;
    /// What is to be drawn now: one tick behind, evenly. Each display has a clock of its own.
    wall::Moment toDraw(wall::FrameClock& clock) const;

private:
    void run();
    void waitToRun();
    bool tick();

    core::Session m_session;  ///< of the thread once it runs
    const std::shared_ptr<const core::World> m_world;
    mutable std::mutex m_mutex;  ///< of what follows up to m_carriedOut
    std::condition_variable m_wake;
    link::SnapshotTrail m_trail;
    std::shared_ptr<const core::Snapshot> m_latest;
    core::State m_state;
    std::vector<core::Event> m_events;
    std::vector<std::pair<std::uint8_t, core::Order>> m_given;
    std::optional<core::SimTime> m_carriedOut;

    std::atomic<double> m_rate{1.0};
    std::atomic<bool> m_running{false};
    std::atomic<bool> m_stop{false};
    std::atomic<bool> m_over{false};
    std::atomic<double> m_lagged_s{0.0};
    std::thread m_thread;
};

}  // namespace sagara::live
