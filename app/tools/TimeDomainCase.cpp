#include <fmt/format.h>

#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/HullChoice.h"
#include "core/base/Units.h"
#include "core/seakeeping/TimeDomain.h"

namespace sagara::tools {
namespace {

constexpr const char* kMotions[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

struct TimeDomainCase {
    std::string hull;
    double froude = 0.0;
    std::vector<double> headings_deg, lambdasOverL;
    double share = 0.0;
    double above = 0.3;  ///< smaller responses: errors over this
};

TimeDomainCase readCase(core::config::Reader& in) {
    TimeDomainCase c;
    c.hull = in.text("hull");
    c.froude = in.numberOr("froude", 0.0, {0.0, 0.4, ""});
    c.headings_deg = in.numbers("headings_deg", 0, {0.0, 180.0, "deg"});
    c.lambdasOverL = in.numbers("lambdasOverL", 0, {0.2, 20.0, ""});
    c.share = readShare(in, "share");
    in.rejectUnknownKeys();
    return c;
}

constexpr std::array<std::size_t, 3> kDrawn{2, 4, 1};

/// A hull in both ways: what the waves do to it by frequency and run in time.
class BothWays {
public:
    BothWays(const core::HullForm& form, double froude)
        : m_length_m(form.lengthBp_m),
          m_speed_mps(froude * std::sqrt(core::kGravity_mps2 * form.lengthBp_m)),
          m_frequency(form),
          m_time(form, {0.0, true, {m_speed_mps}}) {}

    using Sizes = std::array<double, 6>;  ///< over wave amplitude, angles over wave slope
    struct Pair {
        Sizes byFrequency, inTime;
    };
    Pair at(double heading_rad, double lambdaOverL) const {
        const double k = core::kTwoPi / (lambdaOverL * m_length_m);
        const core::MetWave wave{std::sqrt(core::kGravity_mps2 * k), heading_rad, m_speed_mps};
        const double height_m = m_length_m / 50.0;
        return {sizesOf(m_frequency.respond(wave, height_m), k), sizesOf(m_time.respond(wave, height_m), k)};
    }

private:
    static Sizes sizesOf(const core::WaveResponse& response, double waveNumber_radpm) {
        Sizes sizes{};
        for (std::size_t i = 0; i < 6; ++i)
            sizes[i] = std::abs(response.atGravity[i]) / (i < 3 ? 1.0 : waveNumber_radpm);
        return sizes;
    }

    double m_length_m, m_speed_mps;
    core::HullResponse m_frequency;
    core::TimeDomainHull m_time;
};

report::XyPlot emptyPlot(double heading_deg) {
    report::XyPlot plot;
    plot.note = fmt::format("Heading {:g} deg. Lines: frequency domain; points: run in time.", heading_deg);
    plot.xTitle = "wavelength / ship length";
    plot.yTitle = "over wave amplitude; angles over wave slope";
    for (const std::size_t i : kDrawn) plot.series.push_back({kMotions[i], false, {}});
    for (const std::size_t i : kDrawn)
        plot.series.push_back({std::string(kMotions[i]) + ", in time", true, {}});
    return plot;
}

}  // namespace

/// The hull run through regular waves against the same hull in the frequency domain.
ValidationOutcome runTimeDomainCase(const ValidationContext& context, core::config::Reader& in) {
    const TimeDomainCase c = readCase(in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto form = readHullFile(context.reference(c.hull).string());
    if (!form) return outcome.trouble = form.error(), outcome;
    const BothWays hull(*form, c.froude);
    std::array<RelativeErrors, 6> errors;
    for (const double heading_deg : c.headings_deg) {
        report::XyPlot plot = emptyPlot(heading_deg);
        for (const double lambdaOverL : c.lambdasOverL) {
            const BothWays::Pair pair = hull.at(heading_deg * core::kDegree_rad, lambdaOverL);
            for (std::size_t i = 0; i < 6; ++i) errors[i].add(pair.inTime[i], pair.byFrequency[i], c.above);
            for (std::size_t j = 0; j < kDrawn.size(); ++j) {
                plot.series[j].at.emplace_back(lambdaOverL, pair.byFrequency[kDrawn[j]]);
                plot.series[j + kDrawn.size()].at.emplace_back(lambdaOverL, pair.inTime[kDrawn[j]]);
            }
        }
        if (outcome.plots.empty()) outcome.plots.push_back(std::move(plot));
    }
    for (std::size_t i = 0; i < 6; ++i)
        outcome.rows.push_back(largestErrorRow(kMotions[i], errors[i], c.share));
    return outcome;
}

}  // namespace sagara::tools
