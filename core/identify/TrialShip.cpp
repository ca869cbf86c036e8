#include "core/identify/TrialShip.h"

#include <algorithm>
#include <cmath>

#include "core/motion/RungeKutta.h"

namespace sagara::core {

TrialShip::TrialShip(const Vessel& vessel, std::string_view model)
    : m_vessel(vessel),
      m_propellers(propellersOf(m_vessel.propulsion)),
      m_dynamics(m_vessel, m_calm, model) {}

void TrialShip::begin(const Approach& approach) {
    m_motion = {};
    m_motion.surge_mps = approach.speed_mps;
    m_gear = {};
    m_shafts = {};
    m_time_s = 0.0;
    for (ShaftState& shaft : m_shafts) shaft.order_rps = shaft.speed_rps = approach.shaft_rps;
}

void TrialShip::orderShafts(double speed_rps) {
    for (ShaftState& shaft : m_shafts) shaft.order_rps = speed_rps;
}

void TrialShip::step(double step_s) {
    Actuators actuators;
    actuators.rudder_rad = runSteeringGear(m_vessel.steering, m_gear, step_s);
    runShafts(m_propellers, m_shafts, m_motion, m_vessel.steering.rudders.empty() ? m_gear.angle_rad : 0.0,
              m_vessel.hull.waterDensity_kgpm3, step_s);
    showShafts(m_propellers, m_shafts, actuators);
    m_motion = rk4Step(m_motion, step_s,
                       [&](const ShipMotion& m) { return m_dynamics.derivative(m, actuators, {}, {}, {}); });
    m_time_s += step_s;
}

double TrialShip::speed_mps() const { return std::hypot(m_motion.surge_mps, m_motion.sway_mps); }

bool TrialShip::finite() const {
    const ShipMotion& m = m_motion;
    return std::isfinite(m.north_m + m.east_m + m.heading_rad + m.surge_mps + m.sway_mps + m.yawRate_radps +
                         m.roll_rad + m.rollRate_radps);
}

TrialSample TrialShip::sample() const {
    const ShipMotion& m = m_motion;
    double shafts_rps = 0.0;
    const std::size_t count = m_vessel.propulsion.units.size();
    for (std::size_t i = 0; i < count; ++i) shafts_rps += m_shafts[i].speed_rps;
    return {m_time_s,         m.north_m,
            m.east_m,         m.heading_rad,
            m.surge_mps,      m.sway_mps,
            m.yawRate_radps,  m.roll_rad,
            m_gear.angle_rad, shafts_rps / static_cast<double>(std::max<std::size_t>(1, count))};
}

Approach TrialShip::steadyAt(double shaft_rps) {
    begin({m_motion.surge_mps, shaft_rps});
    constexpr double kStep_s = 0.25, kLongest_s = 7200.0;
    double before_mps = m_motion.surge_mps - 1.0;
    while (m_time_s < kLongest_s && std::abs(m_motion.surge_mps - before_mps) > 1e-6) {
        before_mps = m_motion.surge_mps;
        step(kStep_s);
    }
    return {m_motion.surge_mps, shaft_rps};
}

Approach TrialShip::holding(double speed_mps) {
    // Speed is nearly proportional to shaft speed: three proportional corrections reach 1e-6.
    Approach approach = fullAhead();
    for (int i = 0; i < 6 && approach.speed_mps > 0.0; ++i) {
        if (std::abs(approach.speed_mps / speed_mps - 1.0) < 1e-6) break;
        approach = steadyAt(approach.shaft_rps * speed_mps / approach.speed_mps);
    }
    return {speed_mps, approach.shaft_rps};
}

Approach TrialShip::fullAhead() {
    return steadyAt(m_vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::FullAhead)]);
}

TrialRecord::TrialRecord(Trial& trial, const TrialOptions& options, const Approach& approach,
                         double longest_s)
    : m_trial(trial),
      m_options(options),
      m_sample_s(options.sample_s.value_or(
          std::clamp(0.02 * trial.length_m / std::max(0.1, approach.speed_mps), 0.1, 5.0))),
      m_longest_s(options.duration_s.value_or(longest_s)) {
    trial.approach_mps = approach.speed_mps;
}

bool TrialRecord::goesOn(const TrialShip& ship, double share) {
    const TrialSample now = ship.sample();
    if (!ship.finite()) return m_trial.end = TrialEnd::NotFinite, false;
    const double due_s = m_trial.samples.empty() ? 0.0 : m_trial.samples.back().time_s + m_sample_s;
    if (now.time_s >= due_s - 1e-6) m_trial.samples.push_back(now);
    constexpr double kTell_s = 5.0;  // of the ship's time
    if (m_options.watch && now.time_s >= m_told_s) {
        m_told_s = now.time_s + kTell_s;
        if (!m_options.watch(std::clamp(share, 0.0, 1.0))) return m_trial.end = TrialEnd::Cancelled, false;
    }
    if (now.time_s < m_longest_s - 1e-6) return true;
    if (!m_options.duration_s) m_trial.end = TrialEnd::TimedOut;
    return false;
}

void TrialRecord::finish(const TrialShip& ship) {
    const TrialSample now = ship.sample();
    if (ship.finite() && (m_trial.samples.empty() || m_trial.samples.back().time_s < now.time_s - 1e-6))
        m_trial.samples.push_back(now);
}

}  // namespace sagara::core
