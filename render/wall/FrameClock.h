#pragma once

#include <cstdint>

#include "core/base/SimTime.h"

namespace sagara::wall {

/// The moment of simulation to be drawn now: one tick behind the newest snapshot, moving evenly with the wall
/// clock, so that motion is smooth whatever the frame rate. Sets itself anew when the simulation falls behind
/// (a pause, a busy machine) or was set elsewhere. No clock inside.
class FrameClock {
public:
    /// `rate`: simulation seconds to a second of the wall clock.
    explicit FrameClock(double rate = 1.0) : m_rate(rate) {}

    void setRate(double rate);

    /// `newest`: of the snapshots there are; `wall_us`: now. The result is never later than `newest`.
    core::SimTime at(std::int64_t wall_us, core::SimTime newest);

private:
    void setTo(core::SimTime time, std::int64_t wall_us);

    double m_rate;
    bool m_set = false;
    std::int64_t m_wall_us = 0;  ///< when the clock showed m_base
    core::SimTime m_base;
    core::SimTime m_last;  ///< what was said last
};

}  // namespace sagara::wall
