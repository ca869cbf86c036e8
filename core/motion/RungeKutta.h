#pragma once

namespace sagara::core {

/// One classical Runge-Kutta step. It sees addition, scaling and f, nothing about ships.
template <typename State, typename F>
State rk4Step(const State& x, double dt_s, F&& f) {
    const State k1 = f(x), k2 = f(x + 0.5 * dt_s * k1);
    const State k3 = f(x + 0.5 * dt_s * k2), k4 = f(x + dt_s * k3);
    return x + (dt_s / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

}  // namespace sagara::core
