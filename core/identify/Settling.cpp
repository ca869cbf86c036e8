#include "core/identify/Settling.h"

#include <cmath>

#include "core/identify/TrialShip.h"

namespace sagara::core {

Settling::Settling(const TrialShip& ship, double lengthTime_s)
    : m_begun_s(ship.state().time_s), m_from_s(m_begun_s), m_lengthTime_s(lengthTime_s) {}

bool Settling::settled(const TrialShip& ship, double step_s) {
    m_sum_rad += step_s * ship.motion().yawRate_radps;
    const double now_s = ship.state().time_s;
    if (now_s - m_from_s < m_lengthTime_s) return false;
    const double mean_radps = m_sum_rad / (now_s - m_from_s);
    const double same_radps = 1e-3 * std::abs(mean_radps) + 1e-5 / m_lengthTime_s;
    const bool steady = std::abs(mean_radps - m_mean_radps) < same_radps;
    m_mean_radps = mean_radps;
    m_from_s = now_s;
    m_sum_rad = 0.0;
    constexpr double kLeast_lengths = 4.0, kMost_lengths = 80.0;
    const double held_lengths = (now_s - m_begun_s) / m_lengthTime_s;
    return held_lengths > kMost_lengths || (steady && held_lengths > kLeast_lengths);
}

}  // namespace sagara::core
