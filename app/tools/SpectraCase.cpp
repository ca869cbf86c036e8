#include <array>
#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/sea/Spectrum.h"

namespace sagara::tools {
namespace {

struct Ordinate {
    const char* column;
    double overPeak;  ///< frequency
};
constexpr Ordinate kOrdinates[] = {{"S_wp", 1.0}, {"S_08wp", 0.8}, {"S_15wp", 1.5}, {"S_25wp", 2.5}};
constexpr std::array<const char*, 3> kMoments{"m0", "m1", "m2"};

double peakOf(const ReferenceTable& table, std::size_t row) { return core::kTwoPi / table.at("Tp", row); }

double ordinate(const ReferenceTable& table, std::size_t row, double omega_radps) {
    const double height_m = table.at("Hs", row), peak_s = table.at("Tp", row);
    return table.text("type", row) == "jonswap"
               ? core::jonswap_m2s(omega_radps, height_m, peak_s, table.at("gamma", row))
               : core::bretschneider_m2s(omega_radps, height_m, peak_s);
}

/// Over the band of the table, 0.3 to 30 times the peak.
std::array<double, 3> momentsOf(const ReferenceTable& table, std::size_t row) {
    const double peak_radps = peakOf(table, row), step = 0.001 * peak_radps;
    std::array<double, 3> moments{};
    for (double omega = 0.3 * peak_radps + step / 2; omega < 30.0 * peak_radps; omega += step) {
        const double share = ordinate(table, row, omega) * step;
        moments[0] += share;
        moments[1] += share * omega;
        moments[2] += share * omega * omega;
    }
    return moments;
}

report::XyPlot plotOf(const ReferenceTable& table) {
    report::XyPlot plot;
    plot.xTitle = "frequency, rad/s";
    plot.yTitle = "S, m² s";
    report::XyPlot::Series published{"published", true, {}};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        report::XyPlot::Series line{table.text("type", row) + ' ' + table.text("Hs", row) + " m " +
                                        table.text("Tp", row) + " s, gamma " + table.text("gamma", row),
                                    false,
                                    {}};
        for (double omega = 0.02; omega <= 3.0; omega += 0.02)
            line.at.emplace_back(omega, ordinate(table, row, omega));
        plot.series.push_back(std::move(line));
        for (const Ordinate& o : kOrdinates)
            published.at.emplace_back(o.overPeak * peakOf(table, row), table.at(o.column, row));
    }
    plot.series.push_back(std::move(published));
    return plot;
}

}  // namespace

ValidationOutcome runSpectraCase(const ValidationContext& context, core::config::Reader& in) {
    const std::string file = in.text("file");
    const double share = readShare(in, "share"), momentShare = readShare(in, "momentShare");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    RelativeErrors ordinates;
    std::array<RelativeErrors, 3> moments;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        for (const Ordinate& o : kOrdinates)
            ordinates.add(ordinate(*table, row, o.overPeak * peakOf(*table, row)), table->at(o.column, row));
        const auto found = momentsOf(*table, row);
        for (std::size_t i = 0; i < found.size(); ++i) moments[i].add(found[i], table->at(kMoments[i], row));
    }
    outcome.rows = {largestErrorRow("ordinates", ordinates, share)};
    for (std::size_t i = 0; i < moments.size(); ++i)
        outcome.rows.push_back(largestErrorRow(kMoments[i], moments[i], momentShare));
    outcome.plots.push_back(plotOf(*table));
    return outcome;
}

}  // namespace sagara::tools
