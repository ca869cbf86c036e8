#include "core/identify/ReverseSpiral.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"
#include "core/identify/Settling.h"
#include "core/identify/TrialShip.h"

namespace sagara::core {
namespace {

/// Steers to a yaw rate and finds the rudder that holds it.
class RateHelm {
public:
    RateHelm(TrialShip& ship, TrialRecord& record, double step_s, double pace_s)
        : m_ship(ship), m_record(record), m_step_s(step_s), m_pace_s(pace_s) {}

    /// Until rudder and yaw rate are steady: over a length run the mean rudder is that of the length before
    /// to 0.001 deg and the mean rate what it should be to 0.0001 of U/L, for speed comes back slowly; at the
    /// earliest after 6 lengths, at the latest after 80. The mean rudder; none: the run is over.
    std::optional<double> hold(double yawRate_radps) {
        constexpr double kLeast_lengths = 6.0, kMost_lengths = 80.0, kSame_rad = 0.001 * kDegree_rad,
                         kSameRate = 1e-4;
        Means before;
        for (double lengths = 1.0; lengths <= kMost_lengths; ++lengths) {
            const auto now = oneLength(yawRate_radps);
            if (!now) return std::nullopt;
            const bool steady =
                std::abs(now->rudder_rad - before.rudder_rad) < kSame_rad && std::abs(now->lack) < kSameRate;
            before = *now;
            if (lengths >= kLeast_lengths && steady) break;
        }
        return before.rudder_rad;
    }
    void begin(double rudder_rad) { m_held_rad = rudder_rad; }

private:
    /// Over a length run; `lack` of yaw rate, over U/L.
    struct Means {
        double rudder_rad = 0.0, lack = 0.0;
    };

    std::optional<Means> oneLength(double yawRate_radps) {
        // Per yaw rate in lengths: twice the rudder that a usual ship takes for it, and as much again in four
        // lengths.
        constexpr double kNow = 2.0, kPerLength = 0.5;
        const double limit_rad = m_ship.vessel().steering.limit_rad;
        Means sum;
        double time_s = 0.0;
        while (time_s < m_pace_s) {
            if (!m_record.goesOn(m_ship, 0.0)) return std::nullopt;
            const double lack = (yawRate_radps - m_ship.motion().yawRate_radps) * m_pace_s;
            m_held_rad =
                std::clamp(m_held_rad + kPerLength * lack * m_step_s / m_pace_s, -limit_rad, limit_rad);
            m_ship.orderRudder(std::clamp(m_held_rad + kNow * lack, -limit_rad, limit_rad));
            m_ship.step(m_step_s);
            sum.rudder_rad += m_step_s * m_ship.sample().rudder_rad;
            sum.lack += m_step_s * lack;
            time_s += m_step_s;
        }
        return Means{sum.rudder_rad / time_s, sum.lack / time_s};
    }

    TrialShip& m_ship;
    TrialRecord& m_record;
    double m_step_s, m_pace_s;
    double m_held_rad = 0.0;
};

double steadyTurn_radps(TrialShip& ship, TrialRecord& record, double step_s, double pace_s) {
    Settling turn(ship, pace_s);
    while (record.goesOn(ship, 0.0)) {
        ship.step(step_s);
        if (turn.settled(ship, step_s)) break;
    }
    return turn.yawRate_radps();
}

}  // namespace

Trial runReverseSpiral(TrialShip& ship, const ReverseSpiral& spiral, const TrialOptions& options) {
    Trial trial;
    trial.title = "Reverse spiral";
    const double length_m = trial.length_m = ship.vessel().hull.lengthBp_m;
    const Approach approach = options.approach ? *options.approach : ship.fullAhead();
    constexpr double kLongest_lengths = 3000.0;
    const double pace_s = length_m / approach.speed_mps;
    TrialRecord record(trial, options, approach, kLongest_lengths * pace_s);
    ship.begin(approach);
    ship.orderRudder(spiral.rudder_rad);
    const double first_radps = steadyTurn_radps(ship, record, options.step_s, pace_s);
    RateHelm helm(ship, record, options.step_s, pace_s);
    helm.begin(spiral.rudder_rad);
    double from_deg = 0.0, to_deg = 0.0;
    for (int i = 0; i <= spiral.steps; ++i) {
        const double rate_radps = first_radps * (1.0 - 2.0 * i / spiral.steps);
        const auto rudder_rad = helm.hold(rate_radps);
        if (!rudder_rad) return record.finish(ship), trial;
        const double rudder_deg = *rudder_rad / kDegree_rad,
                     shown_dps = std::round(rate_radps / kDegree_rad * 1e4) / 1e4 + 0.0;
        trial.measures.push_back({"rudder_deg_at_" + config::formatNumber(shown_dps) + "_dps", rudder_deg});
        if (rate_radps > 0.0) from_deg = std::min(from_deg, rudder_deg);
        if (rate_radps < 0.0) to_deg = std::max(to_deg, rudder_deg);
    }
    while (options.duration_s && record.goesOn(ship, 1.0)) ship.step(options.step_s);
    record.finish(ship);
    trial.measures.push_back({"loop_from_deg", from_deg});
    trial.measures.push_back({"loop_to_deg", to_deg});
    trial.measures.push_back({"spiral_width_deg", to_deg - from_deg});
    return trial;
}

}  // namespace sagara::core
