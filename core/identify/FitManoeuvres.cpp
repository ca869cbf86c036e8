#include "core/identify/FitManoeuvres.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kTied = 0.9;  ///< correlation

NamedModel& modelIn(Vessel& vessel, const std::string& name) {
    for (NamedModel& m : vessel.models)
        if (m.name == name) return m;
    return vessel.models.front();
}

bool ownsRoll(const NamedModel& model) {
    const auto* polynomial = std::get_if<PolynomialModel>(&model.parameters);
    return polynomial && polynomial->Ixx;
}

TrialStart startOf(std::span<const double> own) {
    if (own.empty()) return {};
    return {own[0], own[1], own[2], own[3], own[4]};
}

/// How well a start is known: rudder and heading half a degree, speeds 1 %, swing 2 % of U/L.
std::vector<Unknown> startUnknowns(const SeaTrial& trial, double length_m) {
    if (trial.kind == TrialKind::Speed || trial.kind == TrialKind::Spiral) return {};
    const double pace_mps = length_m / lengthTime_s(trial, length_m);
    const auto about0 = [](double prior) { return Unknown{0.0, prior}; };
    return {about0(0.5 * kDegree_rad), about0(0.01 * pace_mps), about0(0.01 * pace_mps),
            about0(0.02 * pace_mps / length_m), about0(0.5 * kDegree_rad)};
}

bool goesAstern(const SeaTrial* trial) {
    const auto& shafts = (*trial)[Channel::Shaft];
    return trial->shaft_rps.value_or(0.0) < 0.0 ||
           std::any_of(shafts.begin(), shafts.end(), [](double rps) { return rps < 0.0; });
}

/// The problem of one vessel, one model and all her trials.
class Fitter {
public:
    Fitter(const Vessel& vessel, const std::vector<SeaTrial>& trials, const ManoeuvreFitOptions& options)
        : m_vessel(vessel), m_model(vessel.model(options.model).value()->name), m_options(options) {
        const NamedModel& model = modelIn(m_vessel, m_model);
        bool rolls = false;
        for (const SeaTrial& trial : trials) {
            if (trial.kind == TrialKind::MotionLog) continue;
            if (trial.kind == TrialKind::Decay && !ownsRoll(model)) continue;
            rolls = rolls || trial.has(Channel::Roll);
            m_trials.push_back(&trial);
            m_misfits.emplace_back(trial, vessel.hull.lengthBp_m);
        }
        m_coefficients = coefficientsOf(model, options.groups);
        const bool stops = std::any_of(m_trials.begin(), m_trials.end(), goesAstern);
        if (stops && (options.groups.empty() || options.groups.count("astern") > 0))
            for (Coefficient& c : sternwardCoefficients(vessel)) m_coefficients.push_back(std::move(c));
        const auto ofRoll = [](const Coefficient& c) { return c.key.back() == 'K'; };
        if (!rolls && ownsRoll(model))  // nothing would tell them
            m_coefficients.erase(std::remove_if(m_coefficients.begin(), m_coefficients.end(), ofRoll),
                                 m_coefficients.end());
    }

    ManoeuvreFit fit() {
        const FitAnswer startsBefore = leastSquares(problem(m_vessel, false));
        const FitAnswer answer = leastSquares(problem(m_vessel, true));
        ManoeuvreFit result;
        result.found = answer.found && startsBefore.found;
        result.settled = answer.settled;
        result.vessel = m_vessel;
        if (!result.found) return result;
        result.sharpness = answer.sharpness;
        result.meanSquare = answer.meanSquare;
        result.vessel = with(answer.shared);
        tellCoefficients(result, answer);
        result.resistance = resistance(answer);
        for (std::size_t i = 0; i < m_trials.size(); ++i)
            result.trials.push_back(compare(i, startOf(startsBefore.own[i]), startOf(answer.own[i]), result));
        return result;
    }

private:
    Vessel with(std::span<const double> values) const {
        Vessel vessel = m_vessel;
        for (std::size_t i = 0; i < values.size(); ++i) valueIn(vessel, i) = values[i];
        return vessel;
    }

    double& valueIn(Vessel& vessel, std::size_t i) const {
        return m_coefficients[i].in(vessel, modelIn(vessel, m_model));
    }

    FitProblem problem(Vessel& vessel, bool shared) const {
        FitProblem p;
        p.watch = shared ? m_options.watch : nullptr;
        for (std::size_t i = 0; shared && i < m_coefficients.size(); ++i) {
            const Coefficient& c = m_coefficients[i];
            p.shared.push_back({valueIn(vessel, i), c.prior, c.low, c.high});
        }
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            const TrialMisfit& misfit = m_misfits[i];
            p.pieces.push_back({startUnknowns(*m_trials[i], vessel.hull.lengthBp_m), misfit.measurements(),
                                misfit.independent(), [this, i](auto values, auto own, auto out) {
                                    ReplayShip ship(with(values), m_model, m_trials[i]->depth_m);
                                    return m_misfits[i](ship, startOf(own), out);
                                }});
        }
        return p;
    }

    void tellCoefficients(ManoeuvreFit& result, const FitAnswer& answer) {
        for (std::size_t i = 0; i < m_coefficients.size(); ++i) {
            const Coefficient& c = m_coefficients[i];
            result.coefficients.push_back({c, valueIn(m_vessel, i), answer.shared[i], answer.deviation[i]});
            for (std::size_t j = 0; j < i; ++j)
                if (const double r = answer.correlation(i, j); std::abs(r) > kTied)
                    result.ties.push_back({j, i, r});
        }
    }

    double resistance_kgpm(const Vessel& vessel, double speed_mps) const {
        const ReplayShip ship(vessel, m_model, kDeepWater_m);
        ShipMotion straight;
        straight.surge_mps = speed_mps;
        const HullForces f = ship.dynamics().hullForces(straight, ship.actuators(0.0, 0.0));
        return -f.hull.surge_N / (speed_mps * speed_mps);
    }

    std::optional<FittedResistance> resistance(const FitAnswer& answer) const {
        FittedResistance r;
        for (const SeaTrial* t : m_trials) r.speed_mps = std::max(r.speed_mps, approachOf_mps(*t));
        if (r.speed_mps <= 0.0) return std::nullopt;
        r.before_kgpm = resistance_kgpm(m_vessel, r.speed_mps);
        r.after_kgpm = resistance_kgpm(with(answer.shared), r.speed_mps);
        if (r.before_kgpm <= 0.0 || r.after_kgpm <= 0.0) return std::nullopt;
        const std::size_t n = m_coefficients.size();
        std::vector<double> slope(n);  // change by one standard deviation
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<double> moved = answer.shared;
            moved[i] += answer.deviation[i];
            slope[i] = resistance_kgpm(with(moved), r.speed_mps) - r.after_kgpm;
        }
        double variance = 0.0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) variance += slope[i] * slope[j] * answer.correlation(i, j);
        r.deviation_kgpm = std::sqrt(std::max(0.0, variance));
        return r;
    }

    FittedTrial compare(std::size_t i, const TrialStart& before, const TrialStart& after,
                        const ManoeuvreFit& result) const {
        ReplayShip was(m_vessel, m_model, m_trials[i]->depth_m);
        ReplayShip is(result.vessel, m_model, m_trials[i]->depth_m);
        return {m_trials[i]->name, m_trials[i]->kind, after, m_misfits[i].rms(was, before),
                m_misfits[i].rms(is, after)};
    }

    Vessel m_vessel;
    std::string m_model;
    const ManoeuvreFitOptions& m_options;
    std::vector<const SeaTrial*> m_trials;
    std::vector<TrialMisfit> m_misfits;
    std::vector<Coefficient> m_coefficients;
};

}  // namespace

ManoeuvreFit fitManoeuvres(const Vessel& vessel, const std::vector<SeaTrial>& trials,
                           const ManoeuvreFitOptions& options) {
    return Fitter(vessel, trials, options).fit();
}

}  // namespace sagara::core
