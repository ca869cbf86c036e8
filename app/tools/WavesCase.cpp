#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/sea/Dispersion.h"
#include "core/sea/Spectrum.h"

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

double ordinate(const ReferenceTable& table, std::size_t row, double omega_radps) {
    const double height_m = table.at("Hs", row), peak_s = table.at("Tp", row);
    return table.text("type", row) == "jonswap"
               ? core::jonswap_m2s(omega_radps, height_m, peak_s, table.at("gamma", row))
               : core::bretschneider_m2s(omega_radps, height_m, peak_s);
}

void addSpectra(ValidationOutcome& outcome, const ReferenceTable& table, double share, double momentShare) {
    struct Ordinate {
        const char* column;
        double overPeak;
    };
    constexpr Ordinate kOrdinates[] = {{"S_wp", 1.0}, {"S_08wp", 0.8}, {"S_15wp", 1.5}, {"S_25wp", 2.5}};
    constexpr const char* kMoments[] = {"m0", "m1", "m2"};
    RelativeErrors ordinates;
    std::array<RelativeErrors, 3> moments;
    report::XyPlot plot;
    plot.xTitle = "frequency, rad/s";
    plot.yTitle = "S, m² s";
    report::XyPlot::Series published{"published", true, {}};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double peak_radps = core::kTwoPi / table.at("Tp", row), step = 0.001 * peak_radps;
        for (const Ordinate& o : kOrdinates) {
            ordinates.add(ordinate(table, row, o.overPeak * peak_radps), table.at(o.column, row));
            published.at.emplace_back(o.overPeak * peak_radps, table.at(o.column, row));
        }
        std::array<double, 3> m{};
        report::XyPlot::Series line{table.text("type", row) + ' ' + table.text("Hs", row) + " m " +
                                        table.text("Tp", row) + " s, gamma " + table.text("gamma", row),
                                    false,
                                    {}};
        for (double omega = 0.3 * peak_radps + step / 2; omega < 30.0 * peak_radps; omega += step) {
            const double s = ordinate(table, row, omega) * step;
            for (std::size_t i = 0; i < 3; ++i) m[i] += s * std::pow(omega, i);
        }
        for (double omega = 0.02; omega <= 3.0; omega += 0.02)
            line.at.emplace_back(omega, ordinate(table, row, omega));
        for (std::size_t i = 0; i < 3; ++i) moments[i].add(m[i], table.at(kMoments[i], row));
        plot.series.push_back(std::move(line));
    }
    plot.series.push_back(std::move(published));
    outcome.rows = {largestErrorRow("ordinates", ordinates, share)};
    for (std::size_t i = 0; i < 3; ++i)
        outcome.rows.push_back(largestErrorRow(kMoments[i], moments[i], momentShare));
    outcome.plots.push_back(std::move(plot));
}

enum class Of { Dispersion, Encounter, Spectra };

}  // namespace

ValidationOutcome runWavesCase(const ValidationContext& context, Reader& in) {
    const Of of = in.choice<Of>(
        "of", {{"dispersion", Of::Dispersion}, {"encounter", Of::Encounter}, {"spectra", Of::Spectra}});
    const std::string file = in.text("file");
    const double share = readShare(in, "share");
    const double momentShare = of == Of::Spectra ? readShare(in, "momentShare") : 0.0;
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    if (of == Of::Dispersion) addDispersion(outcome, *table, share);
    if (of == Of::Encounter) addEncounter(outcome, *table, share);
    if (of == Of::Spectra) addSpectra(outcome, *table, share, momentShare);
    return outcome;
}

}  // namespace sagara::tools
