#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/sea/Dispersion.h"

namespace sagara::tools {
namespace {

using core::config::Reader;

constexpr double kTableGravity_mps2 = 9.81;  // of the tables of dispersion and encounter

double depthOf(const ReferenceTable& table, std::size_t row) {
    const double depth_m = table.at("depth", row);
    return std::isfinite(depth_m) ? depth_m : core::kDeep_m;
}

void addDispersion(ValidationOutcome& outcome, const ReferenceTable& table, double share) {
    RelativeErrors number, group;
    report::XyPlot plot;
    plot.xTitle = "period, s";
    plot.yTitle = "wavelength, m";
    report::XyPlot::Series published{"published", true, {}};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double omega_radps = core::kTwoPi / table.at("T", row);
        const double k = core::waveNumber_radpm(omega_radps, depthOf(table, row), kTableGravity_mps2);
        number.add(k, table.at("k", row));
        group.add(core::groupSpeed_mps(k, depthOf(table, row), kTableGravity_mps2),
                  table.at("group_speed", row));
        published.at.emplace_back(table.at("T", row), table.at("wavelength", row));
    }
    for (const double depth_m : {core::kDeep_m, 30.0, 15.0, 8.0}) {
        report::XyPlot::Series line{
            depth_m == core::kDeep_m ? "deep" : std::to_string(std::lround(depth_m)) + " m", false, {}};
        for (double period_s = 3.0; period_s <= 20.0; period_s += 0.25)
            line.at.emplace_back(
                period_s,
                core::kTwoPi / core::waveNumber_radpm(core::kTwoPi / period_s, depth_m, kTableGravity_mps2));
        plot.series.push_back(std::move(line));
    }
    plot.series.push_back(std::move(published));
    outcome.rows = {largestErrorRow("wave number", number, share),
                    largestErrorRow("group speed", group, share)};
    outcome.plots.push_back(std::move(plot));
}

void addEncounter(ValidationOutcome& outcome, const ReferenceTable& table, double share) {
    RelativeErrors errors;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double omega_radps = table.at("w", row);
        const double k = core::waveNumber_radpm(omega_radps, core::kDeep_m, kTableGravity_mps2);
        errors.add(core::encounterFrequency_radps(omega_radps, k, table.at("U", row),
                                                  table.at("heading_deg", row) * core::kDegree_rad),
                   table.at("we", row), 1e-2);
    }
    outcome.rows = {largestErrorRow("encounter frequency", errors, share)};
}

}  // namespace

ValidationOutcome runWavesCase(const ValidationContext& context, Reader& in) {
    const bool dispersion = in.choice<bool>("of", {{"dispersion", true}, {"encounter", false}});
    const std::string file = in.text("file");
    const double share = readShare(in, "share");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    (dispersion ? addDispersion : addEncounter)(outcome, *table, share);
    return outcome;
}

}  // namespace sagara::tools
