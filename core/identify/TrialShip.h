#pragma once

#include <array>

#include "core/bridge/ShaftControl.h"
#include "core/bridge/SteeringGear.h"
#include "core/identify/Trial.h"
#include "core/motion/ShipDynamics.h"

namespace sagara::core {

/// A vessel alone in calm deep water with her steering gear and engines, as an exercise moves her, without
/// the exercise.
class TrialShip {
public:
    /// `model`: see ShipDynamics.
    explicit TrialShip(const Vessel& vessel, std::string_view model = {});

    /// Straight ahead at this speed from the origin, time zero.
    void begin(const Approach& approach);
    void orderRudder(double angle_rad) { m_gear.order_rad = angle_rad; }
    void orderShafts(double speed_rps);
    void step(double step_s);

    const Vessel& vessel() const { return m_vessel; }
    const ShipMotion& motion() const { return m_motion; }
    double speed_mps() const;
    bool finite() const;
    TrialSample sample() const;

    /// Steady ahead at a shaft speed. The ship is left there.
    Approach steadyAt(double shaft_rps);
    /// The shaft speed that holds a speed ahead, by the ship's own balance of thrust and resistance.
    Approach holding(double speed_mps);
    Approach fullAhead();

private:
    Vessel m_vessel;
    WaveTable m_calm{1, 1e6};
    std::vector<Propeller> m_propellers;
    ShipDynamics m_dynamics;
    ShipMotion m_motion;
    SteeringGearState m_gear;
    ShaftStates m_shafts{};
    double m_time_s = 0.0;
};

/// Keeps the record of a run: samples at even distances, the watcher told now and then, the end noted.
class TrialRecord {
public:
    /// `longest_s` ends the run where nothing else does.
    TrialRecord(Trial& trial, const TrialOptions& options, const Approach& approach, double longest_s);
    /// After each step; `share` of the manoeuvre done. False when the run is over.
    bool goesOn(const TrialShip& ship, double share);
    void finish(const TrialShip& ship);

private:
    Trial& m_trial;
    const TrialOptions& m_options;
    double m_sample_s;
    double m_longest_s;
    double m_told_s = 0.0;
};

}  // namespace sagara::core
