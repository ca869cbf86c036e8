#include "app/tools/IdentifyReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::tools {
namespace {

using core::kDegree_rad;
using Value = std::optional<double>;

std::string change(const Value& before, const Value& after, double unit, int decimals) {
    if (!before || !after) return "-";
    return fmt::format("{:.{}f} -> {:.{}f}", *before / unit, decimals, *after / unit, decimals);
}

std::string trialLines(const core::ManoeuvreFit& fit) {
    if (fit.trials.empty()) return {};
    std::string text =
        "Root mean square from the record, before -> after (each with the start that suits it best)\n";
    text += fmt::format("{:24} {:>18} {:>16} {:>16} {:>18} {:>16}\n", "trial", "position, L", "heading, deg",
                        "speed, m/s", "yaw rate, deg/s", "roll, deg");
    for (const core::FittedTrial& t : fit.trials) {
        const auto &a = t.before, &b = t.after;
        text += fmt::format(
            "{:24} {:>18} {:>16} {:>16} {:>18} {:>16}\n", t.name, change(a.position_L, b.position_L, 1.0, 3),
            change(a.heading_rad, b.heading_rad, kDegree_rad, 2), change(a.speed_mps, b.speed_mps, 1.0, 3),
            change(a.yawRate_radps, b.yawRate_radps, kDegree_rad, 4),
            change(a.roll_rad, b.roll_rad, kDegree_rad, 2));
        if (a.rudder_rad)
            text += fmt::format("{:24} rudder, deg: {}\n", "",
                                change(a.rudder_rad, b.rudder_rad, kDegree_rad, 2));
        if (std::abs(t.start.rudder_rad) > 0.5 * kDegree_rad)
            text += fmt::format("{:24} her rudders are not felt at {:.1f} deg of the record\n", "",
                                -t.start.rudder_rad / kDegree_rad);
    }
    return text + "\n";
}

std::string coefficientLines(const core::ManoeuvreFit& fit) {
    if (fit.coefficients.empty()) return {};
    std::string text = fmt::format("{:24} {:>12} {:>12} {:>12} {:>12}\n", "coefficient", "before", "after",
                                   "deviation", "believed");
    for (const core::FittedCoefficient& c : fit.coefficients)
        text += fmt::format("{:24} {:12.5g} {:12.5g} {:12.3g} {:12.3g}\n", c.coefficient.name, c.before,
                            c.after, c.deviation, c.coefficient.prior);
    return text + "deviation: one standard deviation after the fit; believed: before it\n\n";
}

std::string untoldLines(const core::ManoeuvreFit& fit) {
    if (fit.coefficients.empty()) return {};
    const auto sharp =
        std::count_if(fit.sharpness.begin(), fit.sharpness.end(), [](double s) { return s > 1.0; });
    std::string text =
        fmt::format("Left over all: {:.2f} of what a good trial can measure\n\n", std::sqrt(fit.meanSquare));
    text += "What the trials cannot determine\n";
    text += fmt::format("  They know {} of {} independent combinations better than was believed before.\n",
                        sharp, fit.sharpness.size());
    std::string untold;
    for (const core::FittedCoefficient& c : fit.coefficients)
        if (!c.told()) untold += (untold.empty() ? "" : ", ") + c.coefficient.name;
    if (!untold.empty()) text += "  No better known than before: " + untold + "\n";
    for (const core::Tie& tie : fit.ties)
        text += fmt::format("  Only together: {} and {} (correlation {:.2f})\n",
                            fit.coefficients[tie.first].coefficient.name,
                            fit.coefficients[tie.second].coefficient.name, tie.correlation);
    if (!fit.settled) text += "  The search ended before it had settled.\n";
    return text + "\n";
}

std::string nomotoLines(const Identified& found) {
    std::string text;
    if (const auto& n = found.nomoto)
        text += fmt::format(
            "Nomoto: K {:.5f} +- {:.5f} 1/s, T {:.1f} +- {:.1f} s at {:.2f} m/s; heading left {:.1f} deg "
            "rms\n",
            n->gain_perS, n->gainDeviation_perS, n->timeConstant_s, n->timeDeviation_s, n->speed_mps,
            n->heading_rad / kDegree_rad);
    else
        text += "Nomoto: no zigzag or turn with a rudder column\n";
    if (const auto& r = found.manoeuvres.resistance)
        text += fmt::format("X_uu: {:.5g} -> {:.5g} +- {:.2g} kg/m at {:.2f} m/s\n", r->before_kgpm,
                            r->after_kgpm, r->deviation_kgpm, r->speed_mps);
    else
        text += "X_uu: her model or her trials do not tell it\n";
    return text + "\n";
}

std::string swingLines(const std::vector<core::SwingFit>& swings, const core::Hull& hull) {
    std::string text;
    for (const core::SwingFit& s : swings) {
        const bool heave = s.motion == core::Channel::Heave, roll = s.motion == core::Channel::Roll;
        const double unit = heave ? 1.0 : kDegree_rad;
        const char *name = heave ? "heave" : roll ? "roll" : "pitch", *in = heave ? "m" : "deg";
        text += fmt::format("{}: period {:.2f} s, damping {:.4f} +- {:.4f} of critical", name,
                            core::kTwoPi / s.frequency_radps, s.linear, s.linearDeviation);
        if (roll)
            text += fmt::format(" + {:.3f} +- {:.3f} a quadratic part, per rad", s.quadratic,
                                s.quadraticDeviation);
        text +=
            fmt::format("; at {:.2f} {} together {:.4f} +- {:.4f}; left {:.2f} {} rms{}\n",
                        s.amplitude / unit, in, s.equivalent(s.amplitude), s.equivalentDeviation(s.amplitude),
                        s.rms / unit, in, s.told() ? "" : "; too little told to be written");
        if (!roll) continue;
        const core::RollMoment moment = core::rollMomentOf(s, hull);
        text += fmt::format("  as a moment: -({:.4g} N m s + {:.4g} N m s2 |p|) p\n", moment.linear_Nms,
                            moment.quadratic_Nms2);
    }
    return text.empty() ? text : text + "\n";
}

}  // namespace

std::string identifyReport(const Identified& found) {
    std::string text = fmt::format("{}, model {}\n\n", found.vessel, found.model);
    text += trialLines(found.manoeuvres) + coefficientLines(found.manoeuvres);
    text += nomotoLines(found) + swingLines(found.swings, found.manoeuvres.vessel.hull) +
            untoldLines(found.manoeuvres);
    for (const std::string& name : found.unused) text += name + ": tells nothing of this model\n";
    return text;
}

std::string coefficientsCsv(const Identified& found) {
    std::string text = "name,before,after,deviation,prior,told\n";
    for (const core::FittedCoefficient& c : found.manoeuvres.coefficients)
        text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{}\n", c.coefficient.name, c.before, c.after,
                            c.deviation, c.coefficient.prior, c.told() ? 1 : 0);
    return text;
}

}  // namespace sagara::tools
