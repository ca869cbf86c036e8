#include "core/identify/Decay.h"

#include <cmath>

#include "core/base/Units.h"
#include "core/identify/TrialShip.h"

namespace sagara::core {
namespace {

constexpr double kLeastShare = 0.05;  // of the first peak: what is smaller tells little

ShipMotion displacement(const Decay& decay) {
    ShipMotion m;
    if (decay.dof == Decay::Dof::Roll) m.roll_rad = decay.start;
    if (decay.dof == Decay::Dof::Heave) m.down_m = decay.start;
    if (decay.dof == Decay::Dof::Pitch) m.pitch_rad = decay.start;
    return m;
}

/// Peaks and crossings of zero of a swinging value, as it is told of it.
class Swings {
public:
    explicit Swings(double start) : m_peaks{std::abs(start)}, m_side(start < 0.0 ? -1.0 : 1.0) {}

    void add(double time_s, double value) {
        if (m_side * value < 0.0) {
            const double share = m_lastValue / (m_lastValue - value);
            m_crossings_s.push_back(m_last_s + share * (time_s - m_last_s));
            m_peaks.push_back(0.0);
            m_side = -m_side;
        }
        if (m_peaks.size() > 1) m_peaks.back() = std::max(m_peaks.back(), m_side * value);
        m_last_s = time_s;
        m_lastValue = value;
    }
    /// Peaks that are complete, which the one after a crossing is when the next crossing comes.
    std::size_t complete() const { return m_peaks.size() - 1; }
    double peak(std::size_t i) const { return m_peaks[i]; }
    double period_s() const {
        const std::size_t halves = m_crossings_s.size();
        if (halves < 2) return 0.0;
        return 2.0 * (m_crossings_s.back() - m_crossings_s.front()) / static_cast<double>(halves - 1);
    }

private:
    std::vector<double> m_peaks;
    std::vector<double> m_crossings_s;
    double m_side;
    double m_last_s = 0.0;
    double m_lastValue = 0.0;
};

void noteMeasures(Trial& trial, const Decay& decay, const Swings& swings) {
    const auto note = [&](const std::string& name, double value) { trial.measures.push_back({name, value}); };
    if (swings.complete() < 2) return;
    std::size_t last = 0;
    while (last + 1 < swings.complete() && swings.peak(last + 1) > kLeastShare * swings.peak(0)) ++last;
    note("period_s", swings.period_s());
    if (last > 0) {
        const double decrement = std::log(swings.peak(0) / swings.peak(last)) / static_cast<double>(last);
        note("damping_ratio", decrement / std::hypot(kPi, decrement));  // of half a period
    }
    note("swings", static_cast<double>(last));
    const double unit = decay.dof == Decay::Dof::Heave ? 1.0 : kDegree_rad;
    for (std::size_t i = 0; i <= last; ++i) note("peak_" + std::to_string(i), swings.peak(i) / unit);
}

}  // namespace

double decayingMotion(const TrialSample& s, Decay::Dof dof) {
    return dof == Decay::Dof::Roll ? s.roll_rad : dof == Decay::Dof::Pitch ? s.pitch_rad : s.heave_m;
}

Trial runDecay(TrialShip& ship, const Decay& decay, const TrialOptions& given) {
    Trial trial;
    trial.title = decay.dof == Decay::Dof::Roll    ? "Roll decay"
                  : decay.dof == Decay::Dof::Heave ? "Heave decay"
                                                   : "Pitch decay";
    trial.length_m = ship.vessel().hull.lengthBp_m;
    TrialOptions options = given;
    constexpr double kSample_s = 0.1, kLongest_s = 600.0;
    if (!options.sample_s) options.sample_s = kSample_s;
    const Approach approach = options.approach.value_or(Approach{});
    TrialRecord record(trial, options, approach, kLongest_s);
    ship.begin(approach);
    ship.displace(displacement(decay));
    Swings swings(decay.start);
    constexpr std::size_t kMostPeaks = 30;
    const auto over = [&] {
        const std::size_t n = swings.complete();
        return n > kMostPeaks || (n > 1 && swings.peak(n - 1) < kLeastShare * swings.peak(0));
    };
    while (record.goesOn(ship, 0.0) && (options.duration_s || !over())) {
        ship.step(options.step_s);
        swings.add(ship.state().time_s, decayingMotion(ship.sample(), decay.dof));
    }
    record.finish(ship);
    noteMeasures(trial, decay, swings);
    return trial;
}

}  // namespace sagara::core
