#pragma once

#include <vector>

#include "core/bridge/ShaftControl.h"
#include "core/bridge/SteeringGear.h"
#include "core/identify/Trial.h"
#include "core/motion/ShipDynamics.h"

namespace sagara::core {

/// A vessel alone in calm water with her steering gear and engines, as an exercise moves her, without
/// the exercise. Without a hull she floats on springs (see ShipDynamics), which is all that manoeuvres need.
class TrialShip {
public:
    /// `model`: see ShipDynamics.
    explicit TrialShip(const Vessel& vessel, std::string_view model = {}, double depth_m = kDeepWater_m,
                       std::shared_ptr<const SeaHull> hull = nullptr);

    /// Straight ahead at this speed from the origin, time zero.
    void begin(const Approach& approach);
    void displace(const ShipMotion& by) { m_state.motion = m_state.motion + by; }
    void orderRudder(double angle_rad) { m_state.gear.order_rad = angle_rad; }
    void orderShafts(double speed_rps);
    void step(double step_s);
    /// A step that is broken where `value(ship)` rises through zero, if it does, for `then()`: an order given
    /// at a heading is given at that heading, not at the end of the step. Tells whether it was.
    template <typename Value, typename Then>
    bool stepThrough(double step_s, Value&& value, Then&& then);

    /// All that changes in a run; taken back to by `restore`.
    struct State {
        ShipMotion motion;
        MemoryState water{};
        SteeringGearState gear;
        ShaftStates shafts{};
        double time_s = 0.0;
    };
    const State& state() const { return m_state; }
    void restore(const State& state) { m_state = state; }

    const Vessel& vessel() const { return m_vessel; }
    const ShipDynamics& dynamics() const { return m_dynamics; }
    double depth_m() const { return m_depth_m; }
    const ShipMotion& motion() const { return m_state.motion; }
    double speed_mps() const;
    bool finite() const;
    TrialSample sample() const;

    /// Steady ahead at a shaft speed. The ship is left there.
    Approach steadyAt(double shaft_rps);
    /// The shaft speed at which thrust balances resistance at a speed straight ahead, all shafts alike. Where
    /// the model's thrust does not depend on the shafts: full ahead.
    Approach holding(double speed_mps);
    Approach fullAhead();

private:
    ShipMotion rate(const ShipMotion& motion, const Actuators& actuators) const;

    Vessel m_vessel;
    bool m_afloat;  ///< on the tables of her hull
    std::vector<Propeller> m_propellers;
    ShipDynamics m_dynamics;
    double m_depth_m;
    State m_state;
};

template <typename Value, typename Then>
bool TrialShip::stepThrough(double step_s, Value&& value, Then&& then) {
    const State before = m_state;
    const double from = value(*this);
    step(step_s);
    const double to = value(*this);
    if (from >= 0.0 || to < 0.0) return false;
    double low = 0.0, high = 1.0, fromLow = from, toHigh = to, share = 1.0;
    constexpr int kTimes = 4;  // of linear interpolation: the motion is nearly straight in a step
    for (int i = 0; i < kTimes && high > low; ++i) {
        share = low + (high - low) * fromLow / (fromLow - toHigh);
        restore(before);
        step(share * step_s);
        const double here = value(*this);
        (here < 0.0 ? low : high) = share;
        (here < 0.0 ? fromLow : toHigh) = here;
    }
    then();
    if (share < 1.0) step((1.0 - share) * step_s);
    return true;
}

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
