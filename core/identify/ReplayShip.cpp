#include "core/identify/ReplayShip.h"

#include <Eigen/Dense>
#include <cmath>

#include "core/bridge/ShaftControl.h"
#include "core/motion/RungeKutta.h"

namespace sagara::core {
namespace {

/// Where a function that falls through zero does so; `halvings` of the interval.
template <typename F>
double fallsThroughZero(double low, double high, F&& f) {
    for (int halvings = 0; halvings < 50; ++halvings) {
        const double middle = 0.5 * (low + high);
        (f(middle) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

ReplayShip::ReplayShip(const Vessel& vessel, std::string_view model, double depth_m)
    : m_vessel(vessel), m_dynamics(m_vessel, model), m_depth_m(depth_m) {}

Actuators ReplayShip::actuators(double rudder_rad, double shaft_rps) const {
    Actuators a;
    a.rudder_rad = rudder_rad;
    for (std::size_t i = 0; i < m_vessel.propulsion.units.size(); ++i) {
        ShaftState shaft;
        shaft.order_rps = shaft_rps;
        const ShaftDemand demand = demandOf(m_vessel.propulsion.units[i], shaft);
        a.shaft_rps[i] = demand.speed_rps;
        a.pitch[i] = demand.pitch;
    }
    if (m_vessel.steering.rudders.empty()) steerDrives(m_vessel.propulsion, rudder_rad, a);
    return a;
}

ShipMotion ReplayShip::rate(const ShipMotion& m, double rudder_rad, double shaft_rps) const {
    return m_dynamics.derivative(m, actuators(rudder_rad, shaft_rps), {}, {}, m_depth_m);
}

void ReplayShip::step(double rudder_rad, double shaft_rps, double step_s) {
    const Actuators now = actuators(rudder_rad, shaft_rps);
    motion = rk4Step(motion, step_s,
                     [&](const ShipMotion& m) { return m_dynamics.derivative(m, now, {}, {}, m_depth_m); });
}

double ReplayShip::holdingShaft_rps(double speed_mps) const {
    if (speed_mps == 0.0) return 0.0;
    ShipMotion straight;
    straight.surge_mps = speed_mps;
    const auto lack = [&](double shaft_rps) { return -rate(straight, 0.0, shaft_rps).surge_mps; };
    const double full_rps =
        m_vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::FullAhead)];
    if (std::abs(lack(full_rps)) < 1e-9) return full_rps;
    constexpr int kRungs = 100;  // up to five times full ahead: thrust need not grow steadily from 0
    for (int i = 1; i <= kRungs; ++i) {
        const double low = 5.0 * full_rps * (i - 1) / kRungs, high = 5.0 * full_rps * i / kRungs;
        if (lack(low) > 0.0 && lack(high) <= 0.0) return fallsThroughZero(low, high, lack);
    }
    return full_rps;
}

std::optional<double> ReplayShip::steadySpeed_mps(double shaft_rps) const {
    const auto gain = [&](double speed_mps) {
        ShipMotion straight;
        straight.surge_mps = speed_mps;
        return rate(straight, 0.0, shaft_rps).surge_mps;
    };
    constexpr double kSlowest_mps = 0.01, kFastest_mps = 60.0;
    if (gain(kSlowest_mps) <= 0.0 || gain(kFastest_mps) >= 0.0) return std::nullopt;
    return fallsThroughZero(kSlowest_mps, kFastest_mps, gain);
}

std::optional<double> ReplayShip::steadyRudder_rad(double yawRate_radps, double shaft_rps, double speed_mps,
                                                   double guess_rad) const {
    const double L = m_vessel.hull.lengthBp_m;
    const Eigen::Vector3d unit(speed_mps, speed_mps, 1.0);
    const auto rates = [&](const Eigen::Vector3d& x) {  // speed ahead and sideways, rudder, in units
        ShipMotion m;
        m.surge_mps = x[0] * unit[0];
        m.sway_mps = x[1] * unit[1];
        m.yawRate_radps = yawRate_radps;
        const ShipMotion d = rate(m, x[2], shaft_rps);
        return Eigen::Vector3d(d.surge_mps, d.sway_mps, d.yawRate_radps * L);
    };
    Eigen::Vector3d x(0.8, -0.4 * yawRate_radps * L / speed_mps, guess_rad);
    constexpr int kTimes = 40;
    constexpr double kSmall = 1e-5;
    for (int i = 0; i < kTimes; ++i) {
        const Eigen::Vector3d f = rates(x);
        Eigen::Matrix3d slope;
        for (int c = 0; c < 3; ++c)
            slope.col(c) = (rates(x + kSmall * Eigen::Vector3d::Unit(c)) - f) / kSmall;
        const Eigen::Vector3d change = slope.colPivHouseholderQr().solve(f);
        const double longest = change.cwiseAbs().maxCoeff();
        if (!std::isfinite(longest)) return std::nullopt;
        x -= change * std::min(1.0, 0.2 / longest);
        if (longest < 1e-9) return x[0] > 0.0 ? std::optional(x[2]) : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace sagara::core
