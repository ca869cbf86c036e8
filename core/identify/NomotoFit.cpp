#include "core/identify/NomotoFit.h"

#include <cmath>

#include "core/base/Units.h"
#include "core/identify/LeastSquares.h"
#include "core/identify/TrialReplay.h"

namespace sagara::core {
namespace {

constexpr double kHeading_rad = 1.0 * kDegree_rad;

std::vector<const SeaTrial*> ofKind(const std::vector<SeaTrial>& trials, TrialKind kind) {
    std::vector<const SeaTrial*> found;
    for (const SeaTrial& t : trials)
        if (t.kind == kind && t.has(Channel::Rudder) && (t.has(Channel::Heading) || t.has(Channel::YawRate)))
            found.push_back(&t);
    return found;
}

/// Headings of a record, from the first on; summed up from yaw rates where it has none.
std::vector<double> headingsOf(const SeaTrial& t) {
    std::vector<double> headings(t.rows(), 0.0);
    const auto& given = t[t.has(Channel::Heading) ? Channel::Heading : Channel::YawRate];
    const auto& times = t[Channel::Time];
    for (std::size_t i = 1; i < headings.size(); ++i)
        headings[i] = t.has(Channel::Heading)
                          ? given[i] - given[0]
                          : headings[i - 1] + 0.5 * (given[i] + given[i - 1]) * (times[i] - times[i - 1]);
    return headings;
}

/// Heading less that of the record, row by row. Own unknowns: rudder that is not felt, yaw rate and heading
/// at the start. Exact between rows with the rudder held at its mean.
bool misfitOf(const SeaTrial& t, const std::vector<double>& headings, std::span<const double> constants,
              std::span<const double> own, std::span<double> out) {
    const double K = constants[0], T = constants[1];
    const auto &times = t[Channel::Time], &rudder = t[Channel::Rudder];
    double r = own[1], heading = own[2];
    for (std::size_t i = 0; i < headings.size(); ++i) {
        if (i > 0) {
            const double dt = times[i] - times[i - 1];
            const double steady = K * (0.5 * (rudder[i] + rudder[i - 1]) - own[0]), left = std::exp(-dt / T);
            heading += steady * dt + (r - steady) * T * (1.0 - left);
            r = steady + (r - steady) * left;
        }
        out[i] = std::isfinite(headings[i]) ? (heading - headings[i]) / kHeading_rad : 0.0;
    }
    return true;
}

}  // namespace

std::optional<NomotoFit> fitNomoto(const std::vector<SeaTrial>& trials, double length_m) {
    auto used = ofKind(trials, TrialKind::Zigzag);
    if (used.empty()) used = ofKind(trials, TrialKind::Turning);
    if (used.empty()) return std::nullopt;
    NomotoFit fit;
    for (const SeaTrial* t : used) {
        fit.trials.push_back(t->name);
        fit.speed_mps += approachOf_mps(*t) / static_cast<double>(used.size());
    }
    const double pace_perS = std::max(0.1, fit.speed_mps) / length_m;
    FitProblem problem;
    // K L/U and T U/L of ships are 0.5 to 3 and 0.5 to 6; the trials decide.
    problem.shared = {{1.5 * pace_perS, 10.0 * pace_perS, 1e-5, 2.0},
                      {2.0 / pace_perS, 20.0 / pace_perS, 0.1, 5000.0}};
    std::vector<std::vector<double>> headings;
    for (const SeaTrial* t : used) headings.push_back(headingsOf(*t));
    double squares = 0.0, rows = 0.0;
    for (std::size_t i = 0; i < used.size(); ++i)
        problem.pieces.push_back(
            {{{0.0, 5.0 * kDegree_rad}, {0.0, 0.1 * pace_perS}, {0.0, kDegree_rad}},
             headings[i].size(),
             1.0 + used[i]->duration_s() * pace_perS,
             [&, i](auto k, auto own, auto out) { return misfitOf(*used[i], headings[i], k, own, out); }});
    const FitAnswer answer = leastSquares(problem);
    if (!answer.found) return std::nullopt;
    for (std::size_t i = 0; i < used.size(); ++i) {
        std::vector<double> misfit(headings[i].size());
        misfitOf(*used[i], headings[i], answer.shared, answer.own[i], misfit);
        for (const double m : misfit) squares += m * m;
        rows += static_cast<double>(misfit.size());
    }
    fit.gain_perS = answer.shared[0];
    fit.timeConstant_s = answer.shared[1];
    fit.gainDeviation_perS = answer.deviation[0];
    fit.timeDeviation_s = answer.deviation[1];
    fit.heading_rad = kHeading_rad * std::sqrt(squares / rows);
    return fit;
}

}  // namespace sagara::core
