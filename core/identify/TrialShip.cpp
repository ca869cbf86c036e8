#include "core/identify/TrialShip.h"

#include <algorithm>
#include <cmath>

#include "core/motion/RungeKutta.h"

namespace sagara::core {

TrialShip::TrialShip(const Vessel& vessel, std::string_view model, double depth_m,
                     std::shared_ptr<const SeaHull> hull)
    : m_vessel(vessel),
      m_afloat(hull != nullptr),
      m_propellers(propellersOf(m_vessel.propulsion)),
      m_dynamics(m_vessel, model, std::move(hull)),
      m_depth_m(depth_m) {}

void TrialShip::begin(const Approach& approach) {
    m_state = {};
    m_state.motion.surge_mps = approach.speed_mps;
    for (std::size_t i = 0; i < m_propellers.size(); ++i) {
        ShaftState& shaft = m_state.shafts[i];
        shaft.order_rps = approach.shaft_rps;
        const ShaftDemand steady = demandOf(m_propellers[i].unit(), shaft);
        shaft.speed_rps = steady.speed_rps;
        shaft.pitch = steady.pitch;
        shaft.running = m_propellers[i].unit().engine && approach.shaft_rps != 0.0;
    }
}

void TrialShip::orderShafts(double speed_rps) {
    for (ShaftState& shaft : m_state.shafts) shaft.order_rps = speed_rps;
}

ShipMotion TrialShip::rate(const ShipMotion& motion, const Actuators& actuators) const {
    return m_dynamics.derivative(motion, actuators, {}, {}, m_depth_m);
}

void TrialShip::step(double step_s) {
    Actuators actuators;
    actuators.rudder_rad = runSteeringGear(m_vessel.steering, m_state.gear, step_s);
    runShafts(m_propellers, m_state.shafts, m_state.motion,
              m_vessel.steering.rudders.empty() ? m_state.gear.angle_rad : 0.0,
              m_vessel.hull.waterDensity_kgpm3, step_s);
    showShafts(m_propellers, m_state.shafts, actuators);
    if (m_afloat) {
        const MovingShip after = rk4Step(
            MovingShip{m_state.motion, m_state.water}, step_s,
            [&](const MovingShip& m) { return m_dynamics.derivative(m, actuators, {}, {}, {}, m_depth_m); });
        m_state.motion = after.motion;
        m_state.water = after.water;
    } else {
        m_state.motion =
            rk4Step(m_state.motion, step_s, [&](const ShipMotion& m) { return rate(m, actuators); });
    }
    m_state.time_s += step_s;
}

double TrialShip::speed_mps() const { return std::hypot(motion().surge_mps, motion().sway_mps); }

bool TrialShip::finite() const {
    const ShipMotion& m = motion();
    return std::isfinite(m.north_m + m.east_m + m.heading_rad + m.surge_mps + m.sway_mps + m.yawRate_radps +
                         m.roll_rad + m.rollRate_radps);
}

TrialSample TrialShip::sample() const {
    const ShipMotion& m = motion();
    double shafts_rps = 0.0;
    const std::size_t count = m_vessel.propulsion.units.size();
    for (std::size_t i = 0; i < count; ++i) shafts_rps += m_state.shafts[i].speed_rps;
    return {m_state.time_s,
            m.north_m,
            m.east_m,
            m.heading_rad,
            m.surge_mps,
            m.sway_mps,
            m.yawRate_radps,
            m.roll_rad,
            m_state.gear.angle_rad,
            shafts_rps / static_cast<double>(std::max<std::size_t>(1, count)),
            m.down_m,
            m.pitch_rad};
}

Approach TrialShip::steadyAt(double shaft_rps) {
    begin({m_state.motion.surge_mps, shaft_rps});
    constexpr double kStep_s = 0.25, kLongest_s = 7200.0;
    double before_mps = m_state.motion.surge_mps - 1.0;
    while (m_state.time_s < kLongest_s && std::abs(m_state.motion.surge_mps - before_mps) > 1e-6) {
        before_mps = m_state.motion.surge_mps;
        step(kStep_s);
    }
    return {m_state.motion.surge_mps, shaft_rps};
}

Approach TrialShip::holding(double speed_mps) {
    if (speed_mps == 0.0) return {};
    ShipMotion straight;
    straight.surge_mps = speed_mps;
    const auto surplus = [&](double shaft_rps) {
        begin({speed_mps, shaft_rps});
        Actuators actuators;
        showShafts(m_propellers, m_state.shafts, actuators);
        return rate(straight, actuators).surge_mps;
    };
    const double full_rps =
        m_vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::FullAhead)];
    if (std::abs(surplus(full_rps)) < 1e-9) return {speed_mps, full_rps};  // no thrust of its own in the set
    constexpr int kRungs = 400;  // up to ten times full ahead: thrust need not grow steadily from 0
    for (int i = 1; i <= kRungs; ++i) {
        double low = 10.0 * full_rps * (i - 1) / kRungs, high = 10.0 * full_rps * i / kRungs;
        if (surplus(low) >= 0.0 || surplus(high) < 0.0) continue;
        for (int halvings = 0; halvings < 60; ++halvings) {
            const double middle = 0.5 * (low + high);
            (surplus(middle) < 0.0 ? low : high) = middle;
        }
        return {speed_mps, high};
    }
    return {speed_mps, full_rps};
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
