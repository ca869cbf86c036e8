#include "core/bridge/ShaftControl.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/bridge/MainEngine.h"

namespace sagara::core {
namespace {

std::int8_t wayOf(double speed_rps) {
    return static_cast<std::int8_t>(speed_rps > 0.0 ? 1 : speed_rps < 0.0 ? -1 : 0);
}

void runTowards(const PropulsionUnit& unit, ShaftState& shaft, double wanted_rps, double dt_s) {
    const double order_rps = shaft.failed ? 0.0 : wanted_rps;
    const double most_rps = unit.shaftRate_rpsps * dt_s * (shaft.failed ? 1.0 / 3.0 : 1.0);
    if (shaft.speed_rps != 0.0) shaft.lastTurned = wayOf(shaft.speed_rps);
    // First to a stand, then the reversing time, then the other way.
    const bool reverses = wayOf(order_rps) * shaft.lastTurned < 0;
    const double target_rps = reverses ? 0.0 : order_rps;
    shaft.speed_rps += std::clamp(target_rps - shaft.speed_rps, -most_rps, most_rps);
    shaft.standing_s = shaft.speed_rps == 0.0 ? std::max(0.0, shaft.standing_s - dt_s) : unit.reversingTime_s;
    if (shaft.standing_s == 0.0) shaft.lastTurned = 0;
}

double steered_rad(const PropulsionUnit& unit, double rudder_rad) {
    return unit.position.x_m < 0.0 ? -rudder_rad : rudder_rad;
}

void turnDrive(const PropulsionUnit& unit, ShaftState& shaft, double rudder_rad, double dt_s) {
    const double most_rad = unit.azimuth->rate_radps * dt_s;
    const double error_rad =
        wrapPi(shaft.azimuthOrder_rad + steered_rad(unit, rudder_rad) - shaft.azimuth_rad);
    shaft.azimuth_rad = wrapPi(shaft.azimuth_rad + std::clamp(error_rad, -most_rad, most_rad));
}

}  // namespace

void runShaft(const PropulsionUnit& unit, ShaftState& shaft, double dt_s) {
    runTowards(unit, shaft, shaft.order_rps, dt_s);
}

ShaftDemand demandOf(const PropulsionUnit& unit, const ShaftState& shaft) {
    if (!unit.pitch) return {shaft.order_rps, 1.0};
    const double speed_rps = std::max(unit.pitch->slowest_rps, std::abs(shaft.order_rps));
    const double pitch = shaft.pitchByHand ? shaft.pitchOrder
                         : speed_rps > 0.0 ? shaft.order_rps / speed_rps
                                           : 0.0;
    return {speed_rps, std::clamp(pitch, unit.pitch->least, unit.pitch->most)};
}

void runShafts(const std::vector<Propeller>& propellers, ShaftStates& shafts, const ShipMotion& m,
               double rudder_rad, double density_kgpm3, double dt_s) {
    for (std::size_t i = 0; i < propellers.size(); ++i) {
        const PropulsionUnit& unit = propellers[i].unit();
        ShaftState& shaft = shafts[i];
        const ShaftDemand wanted = demandOf(unit, shaft);
        if (unit.pitch) {
            const double most = unit.pitch->rate_perS * dt_s;
            shaft.pitch += std::clamp(wanted.pitch - shaft.pitch, -most, most);
        }
        if (unit.azimuth) turnDrive(unit, shaft, rudder_rad, dt_s);
        if (!unit.engine) {
            runTowards(unit, shaft, wanted.speed_rps, dt_s);
        } else {
            const double inflow_mps = inflowOf_mps(unit, m, shaft.azimuth_rad);
            runEngine(propellers[i], shaft, wanted.speed_rps, {inflow_mps, density_kgpm3}, dt_s);
        }
    }
}

void steerDrives(const Propulsion& propulsion, double rudder_rad, Actuators& actuators) {
    for (std::size_t i = 0; i < propulsion.units.size(); ++i)
        if (propulsion.units[i].azimuth)
            actuators.azimuth_rad[i] = steered_rad(propulsion.units[i], rudder_rad);
}

void showShafts(const std::vector<Propeller>& propellers, const ShaftStates& shafts, Actuators& actuators) {
    for (std::size_t i = 0; i < propellers.size(); ++i) {
        actuators.shaft_rps[i] = shafts[i].speed_rps;
        actuators.pitch[i] = shafts[i].pitch;
        actuators.azimuth_rad[i] = shafts[i].azimuth_rad;
    }
}

std::optional<double> startsLeft(const PropulsionUnit& unit, const ShaftState& shaft) {
    if (!unit.engine || !unit.engine->startAir) return std::nullopt;
    return unit.engine->startAir->starts - shaft.airUsed;
}

}  // namespace sagara::core
