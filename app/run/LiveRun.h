#pragma once

#include <atomic>
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

namespace sagara::run {

/// An exercise that runs in a thread of its own at the pace of the clock, and what is to be drawn of it now.
class LiveRun {
public:
    LiveRun(std::shared_ptr<const core::World> world, core::State start, std::vector<core::Command> planned);
    ~LiveRun();

    /// Time runs from now on; until then the first moment is shown.
    void start();
    void stop();
    /// An order from outside; it is carried out in the next tick.
    void give(std::uint8_t ship, core::Order order);
    /// The moment from which pictures show the orders given before the last call of `give` returned; none
    /// while they wait.
    std::optional<core::SimTime> carriedOut() const;
    bool over() const { return m_over; }
    double lagged_s() const { return m_lagged_s; }  ///< simulation time lost because the machine was too slow

    /// What is to be drawn now. For one thread, which need not be the one that started it.
    wall::Moment now();

private:
    void run();
    std::size_t takeOrders();

    core::Session m_session;     ///< of the thread once it runs
    mutable std::mutex m_mutex;  ///< of the next three
    link::SnapshotTrail m_trail;
    std::vector<std::pair<std::uint8_t, core::Order>> m_given;
    std::optional<core::SimTime> m_carriedOut;
    wall::FrameClock m_clock;
    std::atomic<bool> m_stop{false};
    std::atomic<bool> m_over{false};
    std::atomic<double> m_lagged_s{0.0};
    std::thread m_thread;
};

/// The same without a clock: every frame is a fixed time after the one before, however long it takes to draw.
class SteppedRun {
public:
    SteppedRun(std::shared_ptr<const core::World> world, core::State start,
               std::vector<core::Command> planned, double frame_s);
    void start() { m_started = true; }
    bool over() const { return m_session.over(); }
    wall::Moment next();

private:
    core::Session m_session;
    link::SnapshotTrail m_trail;
    double m_frame_s;
    std::int64_t m_frames = 0;
    std::int64_t m_first_us;
    bool m_started = false;
};

}  // namespace sagara::run
