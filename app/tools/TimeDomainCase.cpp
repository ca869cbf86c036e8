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

}  // namespace

/// The hull run through regular waves against the same hull in the frequency domain.
ValidationOutcome runTimeDomainCase(const ValidationContext& context, core::config::Reader& in) {
    const TimeDomainCase c = readCase(in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto form = readHullFile(context.reference(c.hull).string());
    if (!form) return outcome.trouble = form.error(), outcome;
    const double speed_mps = c.froude * std::sqrt(core::kGravity_mps2 * form->lengthBp_m);
    const double height_m = form->lengthBp_m / 50.0;
    const core::HullResponse frequency(*form);
    const core::TimeDomainHull time(*form, {0.0, true, {speed_mps}});
    std::array<RelativeErrors, 6> errors;
    constexpr std::array<std::size_t, 3> kDrawn{2, 4, 1};  // heave, pitch, sway
    report::XyPlot plot;
    plot.note = fmt::format("Heading {:g} deg. Lines: frequency domain; points: run in time.",
                            c.headings_deg.empty() ? 0.0 : c.headings_deg.front());
    plot.xTitle = "wavelength / ship length";
    plot.yTitle = "over wave amplitude; angles over wave slope";
    for (const char* name : {"heave", "pitch", "sway"}) plot.series.push_back({name, false, {}});
    for (const char* name : {"heave, in time", "pitch, in time", "sway, in time"})
        plot.series.push_back({name, true, {}});
    for (const double heading_deg : c.headings_deg) {
        for (const double lambdaOverL : c.lambdasOverL) {
            const double k = core::kTwoPi / (lambdaOverL * form->lengthBp_m);
            const core::MetWave wave{std::sqrt(core::kGravity_mps2 * k), heading_deg * core::kDegree_rad,
                                     speed_mps};
            const core::WaveResponse a = time.respond(wave, height_m), b = frequency.respond(wave, height_m);
            const auto size = [&](const core::WaveResponse& r, std::size_t i) {
                return std::abs(r.atGravity[i]) / (i < 3 ? 1.0 : k);
            };
            for (std::size_t i = 0; i < 6; ++i) errors[i].add(size(a, i), size(b, i), c.above);
            if (heading_deg != c.headings_deg.front()) continue;
            for (std::size_t j = 0; j < kDrawn.size(); ++j) {
                plot.series[j].at.emplace_back(lambdaOverL, size(b, kDrawn[j]));
                plot.series[j + kDrawn.size()].at.emplace_back(lambdaOverL, size(a, kDrawn[j]));
            }
        }
    }
    for (std::size_t i = 0; i < 6; ++i)
        outcome.rows.push_back(largestErrorRow(kMotions[i], errors[i], c.share));
    outcome.plots.push_back(std::move(plot));
    return outcome;
}

}  // namespace sagara::tools
