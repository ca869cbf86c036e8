#include "core/identify/SwingFit.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/identify/LeastSquares.h"
#include "core/identify/WaveDrive.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/Waterplane.h"

namespace sagara::core {
namespace {

/// What the vessel's document says of the swing.
struct Swing {
    double frequency_radps, damping, addedShare;  ///< added mass over mass and added mass
};
Swing swingOf(const Vessel& vessel, Channel motion) {
    const Hull& hull = vessel.hull;
    const Seakeeping& s = vessel.seakeeping;
    const auto with = [](double stiffness, double inertia, double added, double damping) {
        return Swing{std::sqrt(stiffness / (inertia * (1.0 + added))), damping, added / (1.0 + added)};
    };
    const double mass_kg = hull.mass_kg(), weight_Npm3 = hull.waterDensity_kgpm3 * kGravity_mps2;
    const auto inertia_kgm2 = [&](double gyradius_m) { return mass_kg * gyradius_m * gyradius_m; };
    if (motion == Channel::Roll)
        return with(mass_kg * kGravity_mps2 * hull.metacentricHeight_m, inertia_kgm2(hull.rollGyradius_m),
                    s.rollAddedInertiaRatio, s.rollDampingRatio);
    if (motion == Channel::Heave)
        return with(weight_Npm3 * hull.waterplaneArea_m2(), mass_kg, s.heaveAddedMassRatio,
                    s.heaveDampingRatio);
    const Waterplane plane = waterplaneOf(hull);
    return with(weight_Npm3 * plane.breadth_m * std::pow(plane.length_m, 3) / 12.0,
                inertia_kgm2(hull.pitchGyradius_m), s.pitchAddedInertiaRatio, s.pitchDampingRatio);
}

struct State {
    double x = 0.0, rate = 0.0;
    friend State operator+(const State& a, const State& b) { return {a.x + b.x, a.rate + b.rate}; }
    friend State operator*(double s, const State& a) { return {s * a.x, s * a.rate}; }
};

/// One record of the motion. Shared unknowns: w, zeta, d; own: start, rate at the start, mean, and of the
/// wave the parts in phase and a quarter later.
class Record {
public:
    Record(const SeaTrial& trial, Channel motion, const Vessel& vessel, const Swing& swing)
        : m_trial(trial), m_values(trial[motion]), m_roll(motion == Channel::Roll), m_swing(swing) {
        constexpr double kEnds =
            0.05;  // of a log: there its spectrum knows nothing of the wave before and after
        const bool waves = trial.kind == TrialKind::MotionLog;
        if (waves) m_drive.emplace(trial, motion, vessel.hull, 4.0 * swing.frequency_radps);
        m_first = waves ? static_cast<std::size_t>(kEnds * static_cast<double>(trial.rows())) : 0;
        m_end = trial.rows() - m_first;
        double sum = 0.0, squares = 0.0, count = 0.0;
        for (std::size_t i = m_first; i < m_end; ++i) {
            if (!std::isfinite(m_values[i])) continue;
            sum += m_values[i];
            squares += m_values[i] * m_values[i];
            ++count;
        }
        m_mean = sum / std::max(1.0, count);
        m_rms = std::sqrt(std::max(1e-12, squares / std::max(1.0, count) - (waves ? m_mean * m_mean : 0.0)));
        m_deviation = 0.05 * m_rms;
    }

    double rms() const { return m_rms; }
    double deviation() const { return m_deviation; }
    /// How well the record can be followed; not better than a five hundredth of the motion.
    void setDeviation(double deviation) { m_deviation = std::max(deviation, 0.002 * m_rms); }
    double left(const FitAnswer& answer, std::size_t i) const {
        std::vector<double> out(rows());
        misfit(answer.shared, answer.own[i], out);
        double squares = 0.0;
        for (const double m : out) squares += m * m;
        return m_deviation * std::sqrt(squares / static_cast<double>(out.size()));
    }
    std::size_t rows() const { return m_end - m_first; }
    double duration_s() const { return time(m_end - 1) - time(m_first); }

    std::vector<Unknown> own() const {
        const double start = std::isfinite(m_values[m_first]) ? m_values[m_first] : m_mean;
        std::vector<Unknown> unknowns{{start, 2.0 * m_rms},
                                      {0.0, 2.0 * m_rms * m_swing.frequency_radps},
                                      {m_drive ? m_mean : 0.0, 0.2 * m_rms}};
        if (m_drive) unknowns.insert(unknowns.end(), 2, Unknown{0.0, 2.0});
        return unknowns;
    }

    bool misfit(std::span<const double> shared, std::span<const double> own, std::span<double> out) const {
        State state{own[0] - own[2], own[1]};
        for (std::size_t i = m_first; i < m_end; ++i) {
            if (i > m_first) state = run(state, time(i - 1), time(i), shared, own);
            const double x = state.x + own[2];
            out[i - m_first] = std::isfinite(m_values[i]) ? (x - m_values[i]) / deviation() : 0.0;
        }
        return true;
    }

private:
    double time(std::size_t row) const { return m_trial[Channel::Time][row]; }

    State run(State state, double from_s, double to_s, std::span<const double> shared,
              std::span<const double> own) const {
        constexpr double kPerRadian = 6.0;
        const auto steps = static_cast<int>(std::ceil((to_s - from_s) * shared[0] * kPerRadian));
        const double step_s = (to_s - from_s) / steps;
        for (int i = 0; i < steps; ++i) {
            const double wave = m_drive ? push(from_s + (i + 0.5) * step_s, shared, own) : 0.0;
            state = rk4Step(state, step_s, [&](const State& s) {
                return State{s.rate, wave - shared[0] * shared[0] * s.x -
                                         2.0 * shared[1] * shared[0] * s.rate -
                                         shared[2] * s.rate * std::abs(s.rate)};
            });
        }
        return state;
    }

    double push(double time_s, std::span<const double> shared, std::span<const double> own) const {
        const double w = shared[0];
        const auto of = [&](const WaveDrive::Values& v) {
            return m_roll ? w * w * v[0]
                          : w * w * v[0] + 2.0 * shared[1] * w * v[1] + m_swing.addedShare * v[2];
        };
        return own[3] * of(m_drive->inPhase(time_s)) + own[4] * of(m_drive->aQuarterLater(time_s));
    }

    const SeaTrial& m_trial;
    const std::vector<double>& m_values;
    bool m_roll;
    Swing m_swing;
    std::optional<WaveDrive> m_drive;
    std::size_t m_first = 0, m_end = 0;
    double m_mean = 0.0, m_rms = 0.0, m_deviation = 0.0;
};

FitProblem problemOf(const std::vector<Record>& records, const Swing& swing, Channel motion,
                     double startShare) {
    FitProblem problem;
    const double w = startShare * swing.frequency_radps;
    const bool roll = motion == Channel::Roll;
    problem.shared = {{w, 0.3 * w, 0.3 * w, 3.0 * w},
                      {swing.damping, std::max(0.1, swing.damping), 0.0, 1.5}};
    problem.shared.push_back(roll ? Unknown{0.0, 2.0, 0.0, 20.0} : Unknown{0.0, 1e-6, 0.0, 1e-6});
    for (const Record& r : records)
        problem.pieces.push_back(
            {r.own(), r.rows(), 1.0 + r.duration_s() * w / kPi,
             [&r](auto shared, auto own, auto out) { return r.misfit(shared, own, out); }});
    return problem;
}

/// The best of several first guesses of the frequency: a swing out of step cannot find the way by itself.
FitAnswer best(const std::vector<Record>& records, const Swing& swing, Channel motion) {
    FitAnswer found;
    for (const double startShare : {1.0, 0.8, 1.25, 0.65, 1.5}) {
        const FitAnswer answer = leastSquares(problemOf(records, swing, motion, startShare));
        if (answer.found && (!found.found || answer.meanSquare < 0.98 * found.meanSquare)) found = answer;
    }
    return found;
}

void take(SwingFit& fit, const FitAnswer& answer) {
    fit.frequency_radps = answer.shared[0];
    fit.frequencyDeviation_radps = answer.deviation[0];
    fit.linear = answer.shared[1];
    fit.linearDeviation = answer.deviation[1];
    if (fit.motion != Channel::Roll) return;
    fit.quadratic = answer.shared[2];
    fit.quadraticDeviation = answer.deviation[2];
    fit.covariance = answer.covariance[1 * 3 + 2];
}

}  // namespace

double SwingFit::equivalent(double atAmplitude) const {
    return linear + 4.0 / (3.0 * kPi) * quadratic * atAmplitude;
}

double SwingFit::equivalentDeviation(double atAmplitude) const {
    const double slope = 4.0 / (3.0 * kPi) * atAmplitude;
    return std::sqrt(std::max(0.0, linearDeviation * linearDeviation + 2.0 * slope * covariance +
                                       slope * slope * quadraticDeviation * quadraticDeviation));
}

RollMoment rollMomentOf(const SwingFit& roll, const Hull& hull) {
    const double stiffness_Nm = hull.mass_kg() * kGravity_mps2 * hull.metacentricHeight_m;
    const double inertia_kgm2 = stiffness_Nm / (roll.frequency_radps * roll.frequency_radps);
    return {2.0 * roll.linear * roll.frequency_radps * inertia_kgm2, roll.quadratic * inertia_kgm2};
}

bool SwingFit::told() const { return equivalentDeviation(amplitude) < equivalent(amplitude) / 3.0; }

std::optional<SwingFit> fitSwing(const Vessel& vessel, const std::vector<SeaTrial>& trials, Channel motion) {
    const Swing swing = swingOf(vessel, motion);
    std::vector<Record> records;
    SwingFit fit;
    fit.motion = motion;
    for (const SeaTrial& t : trials) {
        const bool decay = t.kind == TrialKind::Decay && motion == Channel::Roll;
        if (!(decay || t.kind == TrialKind::MotionLog) || !t.has(motion)) continue;
        records.emplace_back(t, motion, vessel, swing);
        fit.trials.push_back(t.name);
        fit.amplitude = std::max(fit.amplitude, std::sqrt(2.0) * records.back().rms());
    }
    if (records.empty()) return std::nullopt;
    FitAnswer answer = best(records, swing, motion);
    if (!answer.found) return std::nullopt;
    for (std::size_t i = 0; i < records.size(); ++i) records[i].setDeviation(records[i].left(answer, i));
    if (const FitAnswer again = best(records, swing, motion); again.found) answer = again;
    take(fit, answer);
    double squares = 0.0, rows = 0.0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto count = static_cast<double>(records[i].rows());
        squares += count * std::pow(records[i].left(answer, i), 2);
        rows += count;
    }
    fit.rms = std::sqrt(squares / rows);
    return fit;
}

}  // namespace sagara::core
