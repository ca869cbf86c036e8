#include "render/wall/FrameClock.h"

#include <algorithm>
#include <cmath>

namespace sagara::wall {

void FrameClock::setRate(double rate) {
    if (rate == m_rate) return;
    m_rate = rate;
    m_set = false;
}

core::SimTime FrameClock::at(std::int64_t wall_us, core::SimTime newest) {
    const double tick_us = std::max(1.0, m_rate) * static_cast<double>(core::kTick_us);
    const core::SimTime time{m_base.us + static_cast<std::int64_t>(std::llround(
                                             m_rate * static_cast<double>(wall_us - m_wall_us)))};
    // Far behind the newest, or the run was set back.
    if (!m_set || time.us < newest.us - static_cast<std::int64_t>(5.0 * tick_us) || newest < m_last) {
        setTo({newest.us - core::kTick_us}, wall_us);
        return m_last = {std::min(m_base.us, newest.us)};
    }
    if (time > newest) {
        // The simulation is later than ever before: stand still until there is half a tick to spare again, so
        // that this happens once and not at every later beat of frames against ticks.
        setTo({newest.us - static_cast<std::int64_t>(0.5 * tick_us)}, wall_us);
        return m_last = newest;
    }
    return m_last = std::max(time, m_last);
}

void FrameClock::setTo(core::SimTime time, std::int64_t wall_us) {
    m_set = true;
    m_base = time;
    m_wall_us = wall_us;
}

}  // namespace sagara::wall
