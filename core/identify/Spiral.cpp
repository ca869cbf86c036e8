#include "core/identify/Spiral.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"
#include "core/identify/Settling.h"
#include "core/identify/TrialShip.h"

namespace sagara::core {
namespace {

constexpr double kFine_deg = 1.0, kCoarse_deg = 5.0, kFineWithin_deg = 5.0;
constexpr int kHalvings = 6;                                // of the step at which the turn changes its side
constexpr double kLeastWidth_deg = 2.0 / (1 << kHalvings);  // what is narrower is the method's own

/// From one side to the other in coarse steps, about amidships in fine ones.
std::vector<double> anglesFrom(double first_deg) {
    std::vector<double> angles;
    const double most = std::abs(first_deg), way = first_deg < 0.0 ? 1.0 : -1.0;
    for (double a = most; a > kFineWithin_deg; a -= kCoarse_deg) angles.push_back(-way * a);
    for (double a = std::min(most, kFineWithin_deg); a > 0.0; a -= kFine_deg) angles.push_back(-way * a);
    const std::size_t half = angles.size();
    angles.push_back(0.0);
    for (std::size_t i = half; i-- > 0;) angles.push_back(-angles[i]);
    return angles;
}

/// Runs the ship at one rudder angle after the other.
class Sweep {
public:
    Sweep(TrialShip& ship, Trial& trial, const TrialOptions& options, TrialRecord& record, double pace_s)
        : m_ship(ship), m_trial(trial), m_step_s(options.step_s), m_record(record), m_pace_s(pace_s) {}

    /// Through all angles; gives the rudder angle, in degrees, at which the turn changes its side.
    double through(const std::vector<double>& angles_deg, const char* moving) {
        double change_deg = 0.0;
        bool changed = false;
        for (std::size_t i = 0; i < angles_deg.size() && m_goesOn; ++i) {
            const TrialShip::State before = m_ship.state();
            const double r_radps = hold(angles_deg[i], true);
            m_trial.measures.push_back({"r_dps_at_" + config::formatNumber(angles_deg[i]) + "_deg_" + moving,
                                        r_radps / kDegree_rad});
            if (!changed && i > 0 && r_radps * before.motion.yawRate_radps < 0.0) {
                changed = true;
                const TrialShip::State after = m_ship.state();
                change_deg = changeBetween(before, angles_deg[i - 1], angles_deg[i]);
                m_ship.restore(after);
            }
        }
        return change_deg;
    }
    bool goesOn() const { return m_goesOn; }

private:
    /// The steady yaw rate.
    double hold(double rudder_deg, bool recorded) {
        m_ship.orderRudder(rudder_deg * kDegree_rad);
        Settling yaw(m_ship, m_pace_s);
        while (!recorded || (m_goesOn = m_record.goesOn(m_ship, 0.0))) {
            m_ship.step(m_step_s);
            if (yaw.settled(m_ship, m_step_s)) break;
        }
        return yaw.yawRate_radps();
    }

    double changeBetween(const TrialShip::State& before, double same_deg, double other_deg) {
        const double side = before.motion.yawRate_radps;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle_deg = 0.5 * (same_deg + other_deg);
            m_ship.restore(before);
            (hold(middle_deg, false) * side > 0.0 ? same_deg : other_deg) = middle_deg;
        }
        return 0.5 * (same_deg + other_deg);
    }

    TrialShip& m_ship;
    Trial& m_trial;
    double m_step_s;
    TrialRecord& m_record;
    double m_pace_s;  ///< one length run
    bool m_goesOn = true;
};

}  // namespace

Trial runSpiral(TrialShip& ship, const Spiral& spiral, const TrialOptions& options) {
    Trial trial;
    trial.title = "Spiral";
    const double length_m = trial.length_m = ship.vessel().hull.lengthBp_m;
    const Approach approach = options.approach ? *options.approach : ship.fullAhead();
    constexpr double kLongest_lengths = 5000.0;
    const double pace_s = length_m / approach.speed_mps;
    TrialRecord record(trial, options, approach, kLongest_lengths * pace_s);
    ship.begin(approach);
    std::vector<double> there = anglesFrom(spiral.rudder_rad / kDegree_rad), back = there;
    std::reverse(back.begin(), back.end());
    const bool portFirst = spiral.rudder_rad < 0.0;
    Sweep sweep(ship, trial, options, record, pace_s);
    const double first_deg = sweep.through(there, portFirst ? "to_starboard" : "to_port");
    const double second_deg = sweep.through(back, portFirst ? "to_port" : "to_starboard");
    const double from_deg = portFirst ? second_deg : first_deg, to_deg = portFirst ? first_deg : second_deg;
    while (options.duration_s && record.goesOn(ship, 1.0)) ship.step(options.step_s);
    record.finish(ship);
    if (!sweep.goesOn()) return trial;
    trial.measures.push_back({"loop_from_deg", from_deg});
    trial.measures.push_back({"loop_to_deg", to_deg});
    const double width_deg = to_deg - from_deg;
    trial.measures.push_back({"spiral_width_deg", width_deg > kLeastWidth_deg ? width_deg : 0.0});
    trial.measures.push_back({"loop_height_dps", std::abs(*trial.measure("r_dps_at_0_deg_to_port") -
                                                          *trial.measure("r_dps_at_0_deg_to_starboard"))});
    return trial;
}

}  // namespace sagara::core
