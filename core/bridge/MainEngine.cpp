#include "core/bridge/MainEngine.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/bridge/ShaftControl.h"

namespace sagara::core {
namespace {

constexpr double kStep_s = 0.02;  // the shaft of a small ship follows within a tenth of a second
constexpr double kBrake = 0.2, kAirBrakeBelow = 0.35, kStart = 0.3, kNextTry_s = 8.0;
constexpr double kFriction = 0.02, kHold = 0.05;  // of full torque; compression holds a shaft that stands

double wayOf(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

/// One short step of one engine.
class EngineStep {
public:
    EngineStep(const Propeller& propeller, ShaftState& shaft, double order_rps, const PropellerWater& water,
               double dt_s)
        : m_propeller(propeller),
          m_engine(*propeller.unit().engine),
          m_shaft(shaft),
          m_water(water),
          m_dt_s(dt_s),
          m_order_rps(shaft.failed ? 0.0 : order_rps),
          m_way(wayOf(m_order_rps)) {}

    void run() {
        refill();
        if (m_shaft.speed_rps != 0.0) m_shaft.lastTurned = static_cast<std::int8_t>(wayOf(m_shaft.speed_rps));
        m_reverses = m_way * m_shaft.lastTurned < 0.0;
        const bool clutched = !m_engine.startAir;
        if (m_way == 0.0 || m_reverses)
            m_shaft.running = false;
        else if (!m_shaft.running && (m_shaft.standing_s == 0.0 || m_shaft.speed_rps != 0.0))
            m_shaft.running = clutched || turnedByTheWater() || start();
        m_shaft.running ? drive() : coast();
        const bool stands = m_shaft.speed_rps == 0.0;
        if (stands) m_shaft.standing_s = std::max(0.0, m_shaft.standing_s - m_dt_s);
        if (!stands) m_shaft.standing_s = m_propeller.unit().reversingTime_s;
        if (m_shaft.standing_s == 0.0) m_shaft.lastTurned = 0;
    }

private:
    void refill() {
        if (m_engine.startAir)
            m_shaft.airUsed = std::max(0.0, m_shaft.airUsed - m_dt_s / m_engine.startAir->refill_s);
    }
    bool airLeft() const { return m_shaft.airUsed + 1.0 <= m_engine.startAir->starts; }
    double propellerTorque_Nm() const {
        return m_propeller.force(m_shaft.speed_rps, m_shaft.pitch, m_water.inflow_mps, m_water.density_kgpm3)
            .torque_Nm;
    }
    bool turnedByTheWater() const { return m_way * m_shaft.speed_rps >= 0.5 * m_engine.idle_rps; }

    bool start() {
        if (!airLeft()) return false;
        m_shaft.airUsed += 1.0;
        if (m_way * propellerTorque_Nm() <= kStart * m_engine.torque_Nm) return true;
        m_shaft.standing_s = kNextTry_s;
        return false;
    }

    double accelerate(double torque_Nm) { return m_dt_s * torque_Nm / (kTwoPi * m_engine.inertia_kgm2); }

    void drive() {
        double& n_rps = m_shaft.speed_rps;
        const double target_rps = m_way * std::max(std::abs(m_order_rps), m_engine.idle_rps);
        const double most_rps = m_propeller.unit().shaftRate_rpsps * m_dt_s;
        const double change_rps = std::clamp(target_rps - n_rps, -most_rps, most_rps);
        const double water_Nm = propellerTorque_Nm(), friction_Nm = m_way * kFriction * m_engine.torque_Nm;
        const double needed_Nm =
            kTwoPi * m_engine.inertia_kgm2 * change_rps / m_dt_s + water_Nm + friction_Nm;
        const double engine_Nm = m_way * std::clamp(m_way * needed_Nm, 0.0, torqueLimit_Nm(m_engine, n_rps));
        n_rps += accelerate(engine_Nm - water_Nm - friction_Nm);
        if (m_way * n_rps < 0.0) {  // turned over by the water
            n_rps = 0.0;
            m_shaft.running = false;
        }
    }

    /// Without fuel.
    void coast() {
        double& n_rps = m_shaft.speed_rps;
        const bool air = m_engine.startAir.has_value();
        const bool brakes =
            m_reverses && (!air || (airLeft() && std::abs(n_rps) < kAirBrakeBelow * m_engine.full_rps));
        const double water_Nm = propellerTorque_Nm();
        const double holding_Nm = (kFriction + (brakes ? kBrake : 0.0)) * m_engine.torque_Nm;
        if (n_rps == 0.0) {
            const double standing_Nm = std::max(holding_Nm, kHold * m_engine.torque_Nm);
            if (std::abs(water_Nm) > standing_Nm)
                n_rps += accelerate(-water_Nm - wayOf(-water_Nm) * standing_Nm);
            return;
        }
        const double before_rps = n_rps;
        n_rps += accelerate(-water_Nm - wayOf(n_rps) * holding_Nm);
        if (n_rps * before_rps < 0.0) n_rps = 0.0;
    }

    const Propeller& m_propeller;
    const Engine& m_engine;
    ShaftState& m_shaft;
    const PropellerWater& m_water;
    double m_dt_s;
    double m_order_rps;
    double m_way;
    bool m_reverses = false;
};

}  // namespace

double torqueLimit_Nm(const Engine& engine, double speed_rps) {
    return engine.torque_Nm * std::min(1.0, 0.6 + 0.5 * std::abs(speed_rps) / engine.full_rps);
}

void runEngine(const Propeller& propeller, ShaftState& shaft, double order_rps, const PropellerWater& water,
               double dt_s) {
    const int steps = std::max(1, static_cast<int>(std::ceil(dt_s / kStep_s - 1e-9)));
    for (int i = 0; i < steps; ++i) EngineStep(propeller, shaft, order_rps, water, dt_s / steps).run();
}

}  // namespace sagara::core
