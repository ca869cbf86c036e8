#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "app/replay/Film.h"
#include "ui/debrief/Replay.h"

namespace sagara::replay {

/// Runs the whole of a recording again, aside, for what the kinematic track does not hold, and to see whether
/// it comes out as it was recorded.
class OrderScan {
public:
    explicit OrderScan(std::shared_ptr<const Film> film);
    ~OrderScan();
    OrderScan(const OrderScan&) = delete;
    OrderScan& operator=(const OrderScan&) = delete;

    /// Null until it is done.
    std::shared_ptr<const ui::ReplayOrders> result() const { return std::atomic_load(&m_result); }

private:
    void run();

    const std::shared_ptr<const Film> m_film;
    std::shared_ptr<const ui::ReplayOrders> m_result;
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

}  // namespace sagara::replay
