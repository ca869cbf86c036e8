#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/HullChoice.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/seakeeping/Response.h"

namespace sagara::tools {

/// Free roll of a hull by its form alone, against a measured decay: columns roll_abs (deg), zeta_eq and
/// zeta_smooth. Swings to one side and to the other differ by the record's own heel: compared are their
/// means.
ValidationOutcome runRollCase(const ValidationContext& context, core::config::Reader& in) {
    const std::string hull = in.text("hull"), file = in.text("file");
    const double period_s = in.number("period_s", {0.1, 100.0, "s"});
    const double periodShare = readShare(in, "periodShare"), dampingShare = readShare(in, "dampingShare");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto form = readHullFile(context.reference(hull).string());
    if (!form) return outcome.trouble = form.error(), outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    report::XyPlot plot;
    plot.xTitle = "amplitude of the swing, deg";
    plot.yTitle = "damping over critical, %";
    plot.series = {{"Sagara", false, {}}, {"measured, to both sides", true, {}}, {"each swing", true, {}}};
    const core::FreeRoll roll(*form);
    RelativeErrors damping;
    for (std::size_t row = 0; row + 1 < table->rows(); ++row) {
        const double roll_deg = 0.5 * (table->at("roll_abs", row) + table->at("roll_abs", row + 1));
        const double measured = 0.5 * (table->at("zeta_smooth", row) + table->at("zeta_smooth", row + 1));
        if (!std::isfinite(measured)) continue;
        const core::RollMode mode = roll.at(roll_deg * core::kDegree_rad);
        damping.add(mode.dampingRatio, measured);
        plot.series[0].at.emplace_back(roll_deg, 100.0 * mode.dampingRatio);
        plot.series[1].at.emplace_back(roll_deg, 100.0 * measured);
        plot.series[2].at.emplace_back(table->at("roll_abs", row), 100.0 * table->at("zeta_eq", row));
    }
    const double first_rad = table->at("roll_abs", 0) * core::kDegree_rad;
    ValidationRow period;
    period.quantity = "natural roll period, s";
    period.measured = core::kTwoPi / roll.at(first_rad).omega_radps;
    period.reference = period_s;
    period.tolerance = periodShare;
    period.share = true;
    outcome.rows = {period, largestErrorRow("damping ratio", damping, dampingShare)};
    outcome.plots.push_back(std::move(plot));
    return outcome;
}

}  // namespace sagara::tools
