#include "ui/demo/DemoHelm.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using core::TelegraphStep;

constexpr double kRudderStep_rad = 5.0 * core::kDegree_rad;
constexpr double kTremble = 0.08;
constexpr int kStop = static_cast<int>(TelegraphStep::Stop);
constexpr int kLast = static_cast<int>(core::kTelegraphSteps) - 1;

int nearestStep(const core::TelegraphTable& table, double shaft_rps) {
    int best = 0;
    for (int i = 1; i <= kLast; ++i) {
        const auto at = [&](int step) { return table[static_cast<std::size_t>(step)]; };
        if (std::abs(at(i) - shaft_rps) < std::abs(at(best) - shaft_rps)) best = i;
    }
    return best;
}

}  // namespace

bool stickMoved(const StickReading& before, const StickReading& now) {
    return (now.pressed && !before.pressed) || std::abs(now.rudder - before.rudder) > kTremble ||
           std::abs(now.engine - before.engine) > kTremble;
}

DemoHelm::Orders DemoHelm::take(const core::OwnShip& ship, const core::OwnShipView& now) {
    m_limit_rad = ship.vessel.steering.limit_rad;
    m_stick.reset();
    double mean_rps = 0.0;
    for (const double order_rps : now.shaftOrders_rps)
        mean_rps += order_rps / static_cast<double>(now.shaftOrders_rps.size());
    const int going = nearestStep(ship.vessel.propulsion.telegraph_rps, mean_rps);
    Orders orders{core::PilotOrder{false}, core::AutopilotOrder{}};
    for (Orders more :
         {orderRudder(0.0), orderStep(std::max(going, static_cast<int>(TelegraphStep::SlowAhead)))})
        orders.insert(orders.end(), more.begin(), more.end());
    return orders;
}

DemoHelm::Orders DemoHelm::orderRudder(double rudder_rad) {
    m_rudder_rad = std::clamp(rudder_rad, -m_limit_rad, m_limit_rad);
    return {core::HelmOrder{m_rudder_rad}};
}

DemoHelm::Orders DemoHelm::orderStep(int step) {
    m_step = static_cast<TelegraphStep>(std::clamp(step, 0, kLast));
    return {core::TelegraphOrder{core::kAllShafts, m_step}};
}

DemoHelm::Orders DemoHelm::press(Key key) {
    switch (key) {
        case Key::Port:
            return orderRudder(m_rudder_rad - kRudderStep_rad);
        case Key::Starboard:
            return orderRudder(m_rudder_rad + kRudderStep_rad);
        case Key::Midships:
            return orderRudder(0.0);
        case Key::Faster:
            return orderStep(static_cast<int>(m_step) + 1);
        case Key::Slower:
            return orderStep(static_cast<int>(m_step) - 1);
    }
    return {};
}

DemoHelm::Orders DemoHelm::move(const StickReading& stick) {
    if (!m_stick) {
        m_stick = stick;
        return {};
    }
    Orders orders;
    if (std::abs(stick.rudder - m_stick->rudder) > kTremble) {
        m_stick->rudder = stick.rudder;
        const Orders more = orderRudder(stick.rudder * m_limit_rad);
        orders.insert(orders.end(), more.begin(), more.end());
    }
    if (std::abs(stick.engine - m_stick->engine) > kTremble) {
        m_stick->engine = stick.engine;
        const Orders more = orderStep(kStop + static_cast<int>(std::lround(stick.engine * kStop)));
        orders.insert(orders.end(), more.begin(), more.end());
    }
    return orders;
}

}  // namespace sagara::ui
