#include "core/identify/TrialReplay.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

double firstOr(const SeaTrial& trial, Channel c, double fallback) {
    return trial.has(c) && std::isfinite(trial[c].front()) ? trial[c].front() : fallback;
}

/// The rudder of a trial: as recorded, or over at the gear's rate and, in a zigzag, back at each switch.
class Helm {
public:
    Helm(const SeaTrial& trial, const Steering& steering, double heading_rad)
        : m_trial(&trial), m_rate_radps(steering.rate_radps), m_from_rad(heading_rad) {
        if (trial.rudder_rad) m_order_rad = *trial.rudder_rad;
    }
    /// Moves it through a step; the mean angle of it.
    double through(double time_s, double step_s) {
        if (m_trial->has(Channel::Rudder)) return m_trial->at(Channel::Rudder, time_s + 0.5 * step_s);
        const double before_rad = m_angle_rad;
        m_angle_rad += std::clamp(m_order_rad - m_angle_rad, -m_rate_radps * step_s, m_rate_radps * step_s);
        return 0.5 * (before_rad + m_angle_rad);
    }
    /// How far beyond the switch she is; below 0 before it.
    double beyondSwitch_rad(const ShipMotion& m) const {
        if (m_trial->kind != TrialKind::Zigzag || m_trial->has(Channel::Rudder)) return -1.0;
        const double side = m_order_rad < 0.0 ? -1.0 : 1.0;
        return side * (m.heading_rad - m_from_rad) - *m_trial->switch_rad;
    }
    void reverse() { m_order_rad = -m_order_rad; }

private:
    const SeaTrial* m_trial;
    double m_rate_radps;
    double m_from_rad;  ///< heading from which a zigzag counts
    double m_order_rad = 0.0, m_angle_rad = 0.0;
};

ShipMotion startOf(const SeaTrial& trial, const TrialStart& start) {
    ShipMotion m;
    m.north_m = firstOr(trial, Channel::North, 0.0);
    m.east_m = firstOr(trial, Channel::East, 0.0);
    m.heading_rad = firstOr(trial, Channel::Heading, 0.0) + start.heading_rad;
    m.roll_rad = firstOr(trial, Channel::Roll, 0.0);
    m.surge_mps = approachOf_mps(trial) + start.surge_mps;
    m.sway_mps = firstOr(trial, Channel::Sway, 0.0) + start.sway_mps;
    m.yawRate_radps = firstOr(trial, Channel::YawRate, 0.0) + start.yawRate_radps;
    return m;
}

/// Short against a length run and against rolling.
double stepOf_s(const SeaTrial& trial, const Hull& hull) {
    constexpr double kPerLength = 20.0, kPerRoll = 20.0;
    const double gyradius_m = std::max(1e-3, hull.rollGyradius_m);
    const double roll_s =
        kTwoPi * gyradius_m / std::sqrt(kGravity_mps2 * std::max(1e-3, hull.metacentricHeight_m));
    return std::min(lengthTime_s(trial, hull.lengthBp_m) / kPerLength, roll_s / kPerRoll);
}

bool finite(const ShipMotion& m) {
    return std::isfinite(m.north_m + m.east_m + m.heading_rad + m.surge_mps + m.sway_mps + m.yawRate_radps +
                         m.roll_rad);
}

ShipMotion between(const ShipMotion& a, const ShipMotion& b, double share) {
    return (1.0 - share) * a + share * b;
}

}  // namespace

double approachOf_mps(const SeaTrial& trial) {
    if (trial.approach_mps) return *trial.approach_mps;
    return firstOr(trial, Channel::Surge, firstOr(trial, Channel::Speed, 0.0));
}

double steadyShaft_rps(const ReplayShip& ship, const SeaTrial& trial) {
    return trial.shaft_rps ? *trial.shaft_rps : ship.holdingShaft_rps(approachOf_mps(trial));
}

double lengthTime_s(const SeaTrial& trial, double length_m) {
    const double slowest_mps = 0.1 * std::sqrt(kGravity_mps2 * length_m);  // Fn 0.1: a ship at rest rolls on
    return length_m / std::max(slowest_mps, approachOf_mps(trial));
}

std::vector<ShipMotion> replay(ReplayShip& ship, const SeaTrial& trial, const TrialStart& start) {
    const std::vector<double>& times = trial[Channel::Time];
    const double longest_s = stepOf_s(trial, ship.vessel().hull);
    ship.motion = startOf(trial, start);
    Helm helm(trial, ship.vessel().steering, firstOr(trial, Channel::Heading, 0.0));
    const double steady_rps = trial.has(Channel::Shaft) ? 0.0 : steadyShaft_rps(ship, trial);
    const auto advance = [&](double from_s, double step_s) {
        const double shaft_rps =
            trial.has(Channel::Shaft) ? trial.at(Channel::Shaft, from_s + 0.5 * step_s) : steady_rps;
        ship.step(helm.through(from_s, step_s) + start.rudder_rad, shaft_rps, step_s);
    };
    std::vector<ShipMotion> rows{ship.motion};
    double now_s = times.front();
    while (rows.size() < times.size()) {
        const ShipMotion before = ship.motion;
        const Helm helmBefore = helm;
        const double from_s = now_s;
        advance(from_s, longest_s);
        if (const double past = helm.beyondSwitch_rad(ship.motion); past >= 0.0) {
            const double was = helmBefore.beyondSwitch_rad(before);
            const double share = was < 0.0 ? was / (was - past) : 0.0;  // nearly straight in so short a step
            ship.motion = before;
            helm = helmBefore;
            if (share > 0.0) advance(from_s, share * longest_s);
            helm.reverse();
            advance(from_s + share * longest_s, (1.0 - share) * longest_s);
        }
        now_s = from_s + longest_s;
        if (!finite(ship.motion)) return {};
        while (rows.size() < times.size() && times[rows.size()] <= now_s)
            rows.push_back(between(before, ship.motion, (times[rows.size()] - from_s) / longest_s));
    }
    return rows;
}

}  // namespace sagara::core
