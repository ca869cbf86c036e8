#include "core/exercise/Snapshot.h"

#include <algorithm>
#include <cmath>

#include "core/base/Trig.h"
#include "core/base/Units.h"
#include "core/exercise/LocalWater.h"
#include "core/exercise/Observe.h"

namespace sagara::core {
namespace {

/// The rudder does not answer, or nothing drives her. One engine of two, one pump of two still do.
bool unableToManoeuvre(const OwnShip& ship, const OwnShipState& s) {
    constexpr int kPumps = 2;
    const auto end = s.shafts.begin() + static_cast<std::ptrdiff_t>(ship.shaftCount());
    return s.steering.jammed || s.steering.pumpsFailed >= kPumps ||
           std::all_of(s.shafts.begin(), end, [](const ShaftState& shaft) { return shaft.failed; });
}

DriveView viewDrive(const OwnShip& ship, const OwnShipState& s, std::size_t i) {
    const Propeller& propeller = ship.propellers[i];
    const ShaftState& shaft = s.shafts[i];
    DriveView v{.pitch = shaft.pitch,
                .pitchOrder = demandOf(propeller.unit(), shaft).pitch,
                .pitchByHand = shaft.pitchByHand,
                .azimuth_rad = shaft.azimuth_rad,
                .azimuthOrder_rad = shaft.azimuthOrder_rad,
                .torque_Nm = {},
                .startsLeft = startsLeft(propeller.unit(), shaft)};
    if (propeller.knowsTorque()) {
        const double inflow_mps = inflowOf_mps(propeller.unit(), s.motion, shaft.azimuth_rad);
        v.torque_Nm =
            propeller.force(shaft.speed_rps, shaft.pitch, inflow_mps, ship.vessel.hull.waterDensity_kgpm3)
                .torque_Nm;
    }
    return v;
}

OwnShipView viewShip(const OwnShip& ship, const OwnShipState& s, NorthEast current) {
    OwnShipView v;
    v.motion = s.motion;
    v.overGround_mps = overGround_mps(s, current);
    v.rudder_rad = s.steering.angle_rad;
    v.rudderOrder_rad = s.steering.order_rad;
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) {
        v.shafts_rps.push_back(s.shafts[i].speed_rps);
        v.shaftOrders_rps.push_back(s.shafts[i].order_rps);
        v.drives.push_back(viewDrive(ship, s, i));
    }
    v.thrusters.assign(s.thrusters.begin(),
                       s.thrusters.begin() + static_cast<std::ptrdiff_t>(ship.thrusterCount()));
    v.autopilot = s.autopilot;
    v.pilotEngaged = s.pilot.engaged;
    v.lines.assign(s.lines.begin(), s.lines.begin() + static_cast<std::ptrdiff_t>(ship.lines.size()));
    v.anchors.assign(s.anchors.begin(), s.anchors.begin() + static_cast<std::ptrdiff_t>(ship.anchorCount()));
    v.underKeel_m = s.underKeel_m;
    v.aground = s.aground;
    v.notUnderCommand = unableToManoeuvre(ship, s);
    v.pumpsFailed = s.steering.pumpsFailed;
    v.rudderJammed = s.steering.jammed;
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) v.enginesFailed.push_back(s.shafts[i].failed);
    v.freeMotions = s.freeMotions;
    return v;
}

/// Height and slope of the long waves that are longer than twice the ship.
void ride(TargetView& v, double length_m, const ActiveWaves& waves, double shelter) {
    const double longest_radpm = kPi / length_m, c = std::cos(v.heading_rad), s = std::sin(v.heading_rad);
    double up_m = 0.0, slopeNorth = 0.0, slopeEast = 0.0;
    for (std::size_t i = 0; i < waves.count; ++i) {
        const double kN = waves.kNorth_radpm[i], kE = waves.kEast_radpm[i];
        if (kN * kN + kE * kE > longest_radpm * longest_radpm) continue;
        const SinCos wave = sinCos(kN * v.position.north_m + kE * v.position.east_m + waves.phase_rad[i]);
        up_m += waves.amplitude_m[i] * wave.cos;
        slopeNorth -= waves.amplitude_m[i] * kN * wave.sin;
        slopeEast -= waves.amplitude_m[i] * kE * wave.sin;
    }
    v.down_m = -shelter * up_m;
    v.pitch_rad = shelter * (slopeNorth * c + slopeEast * s);
    v.roll_rad = -shelter * (slopeEast * c - slopeNorth * s);
}

}  // namespace

Activity activityOf(const OwnShipView& ship) {
    const auto holdsOn = [](const AnchorState& a) { return a.onBottom && a.cableOut_m > 0.0; };
    const auto isFast = [](const LineState& line) { return line.onBollard(); };
    if (std::any_of(ship.lines.begin(), ship.lines.end(), isFast)) return Activity::Moored;
    if (std::any_of(ship.anchors.begin(), ship.anchors.end(), holdsOn)) return Activity::Anchored;
    return ship.notUnderCommand ? Activity::NotUnderCommand : Activity::UnderWay;
}

Snapshot view(const World& world, const State& state) {
    Snapshot snapshot;
    snapshot.tick = state.tick;
    snapshot.level = state.level;
    snapshot.weather = state.weather.now;
    snapshot.wind = world.gusts.at(state.weather.now.wind, state.time());
    snapshot.sea = state.weather.sea;
    snapshot.tide_m = world.tide.height_m(state.time());
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        snapshot.ships.push_back(viewShip(*world.ships[i], state.ships[i],
                                          currentAt(world, state, state.ships[i].motion.position())));
    }
    const WaterNow water(world, state, state.time());
    ActiveWaves waves;
    activeWaves(world.waves, state.weather.sea, state.time(), waves);
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetState& t = state.targets[i];
        if (!t.present) continue;
        TargetView v{i,
                     t.position,
                     0.0,
                     0.0,
                     0.0,
                     t.heading_rad,
                     t.speed_mps,
                     t.yawRate_radps,
                     activityNow(targetLayout(world, state, i), t)};
        ride(v, targetLayout(world, state, i).length_m, waves, water.waves.factorAt(t.position));
        snapshot.targets.push_back(v);
    }
    snapshot.added = state.added;
    for (const TaskMemory& task : state.assessment.tasks) snapshot.tasks.push_back({task.done, task.doneAt});
    snapshot.score = scoreOf(state.assessment);
    snapshot.failed = state.assessment.failed;
    snapshot.finished = state.finished;
    return snapshot;
}

}  // namespace sagara::core
