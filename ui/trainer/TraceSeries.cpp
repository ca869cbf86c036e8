#include "ui/trainer/TraceSeries.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::ui {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastWay_mps = 0.25;
/// She turns from the first on and goes straight again below the second: yawing in a sea is neither.
constexpr double kTurn_radps = 0.25 * core::kDegree_rad, kStraight_radps = 0.1 * core::kDegree_rad;

}  // namespace

void TraceSeries::clear() {
    m_samples.clear();
    m_speedBefore.reset();
    m_meanTurn_radps = 0.0;
    m_turning = false;
}

double TraceSeries::speedKept_percent(double passed_s, const core::ShipMotion& m) {
    constexpr double kTurnMean_s = 8.0, kSpeedMean_s = 20.0;
    const auto share = [passed_s](double mean_s) { return 1.0 - std::exp(-passed_s / mean_s); };
    const double speed_mps = std::hypot(m.surge_mps, m.sway_mps);
    m_meanTurn_radps += share(kTurnMean_s) * (m.yawRate_radps - m_meanTurn_radps);
    const double rate_radps = std::abs(m_meanTurn_radps);
    if (m_turning && rate_radps < kStraight_radps) m_turning = false;
    if (!m_turning && rate_radps >= kTurn_radps && m_speedBefore && *m_speedBefore > kLeastWay_mps)
        m_turning = true;
    if (!m_turning) {
        if (!m_speedBefore) m_speedBefore = speed_mps;
        *m_speedBefore += share(kSpeedMean_s) * (speed_mps - *m_speedBefore);
        return kNone;
    }
    return 100.0 * speed_mps / *m_speedBefore;
}

void TraceSeries::add(double time_s, const core::ShipMotion& m) {
    if (!m_samples.empty() && time_s < m_samples.back().time_s) clear();
    if (!m_samples.empty() && time_s == m_samples.back().time_s) return;
    const double passed_s = m_samples.empty() ? 0.0 : time_s - m_samples.back().time_s;
    const double way_mps = std::hypot(m.surge_mps, m.sway_mps);
    Sample sample;
    sample.time_s = time_s;
    sample.values = {
        m.surge_mps / core::kKnot_mps,
        m.sway_mps / core::kKnot_mps,
        -m.down_m,
        m.roll_rad / core::kDegree_rad,
        m.pitch_rad / core::kDegree_rad,
        60.0 * m.yawRate_radps / core::kDegree_rad,
        way_mps > kLeastWay_mps ? std::atan2(m.sway_mps, m.surge_mps) / core::kDegree_rad : kNone,
        speedKept_percent(passed_s, m)};
    m_samples.push_back(sample);
    const auto old = std::find_if(m_samples.begin(), m_samples.end(),
                                  [&](const Sample& s) { return s.time_s >= time_s - kLongest_s; });
    // Seldom, and many at once.
    if (old - m_samples.begin() > 500) m_samples.erase(m_samples.begin(), old);
}

}  // namespace sagara::ui
