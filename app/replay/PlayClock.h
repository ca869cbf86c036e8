#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/SimTime.h"

namespace sagara::replay {

/// The moment of a replay: stands, or moves evenly with the wall clock between begin and end. No clock
/// inside.
class PlayClock {
public:
    PlayClock(core::SimTime begin, core::SimTime end) : m_begin(begin), m_end(end), m_base(begin) {}

    core::SimTime at(std::int64_t wall_us) const {
        if (!m_playing) return m_base;
        const double gone_us = m_rate * static_cast<double>(wall_us - m_wall_us);
        return std::min(m_end, core::SimTime{m_base.us + std::llround(gone_us)});
    }
    bool playing(std::int64_t wall_us) const { return m_playing && at(wall_us) < m_end; }
    double rate() const { return m_rate; }

    /// To the tick.
    void seek(core::SimTime time, std::int64_t wall_us) {
        m_playing = playing(wall_us);
        const core::SimTime tick{time.us / core::kTick_us * core::kTick_us};
        m_base = std::clamp(tick, m_begin, m_end);
        m_wall_us = wall_us;
    }
    void play(std::int64_t wall_us) {
        seek(at(wall_us), wall_us);
        m_playing = m_base < m_end;
    }
    void pause(std::int64_t wall_us) {
        seek(at(wall_us), wall_us);
        m_playing = false;
    }
    void setRate(double times, std::int64_t wall_us) {
        m_base = at(wall_us);
        m_wall_us = wall_us;
        m_rate = times;
    }

private:
    core::SimTime m_begin, m_end;
    core::SimTime m_base;
    std::int64_t m_wall_us = 0;  ///< when it showed m_base
    double m_rate = 1.0;
    bool m_playing = false;
};

}  // namespace sagara::replay
