#include <fmt/format.h>

#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/motion/Squat.h"

namespace sagara::tools {
namespace {

struct Formula {
    const char* column;
    const char* name;
    core::SquatFormula formula;
};
constexpr Formula kFormulas[] = {{"barrass_general", "Barrass", core::SquatFormula::Barrass},
                                 {"barrass_simple", "Barrass, simple", core::SquatFormula::BarrassSimple},
                                 {"icorels", "ICORELS", core::SquatFormula::Icorels},
                                 {"yoshimura", "Yoshimura", core::SquatFormula::Yoshimura}};

double squatOf(const ReferenceTable& table, std::size_t row, core::SquatFormula formula, double speed_kn) {
    const auto at = [&](const char* column) { return table.at(column, row); };
    const double width_m = at("W");
    // The table has g = 9.81: the two formulas that go by V^2 / g are asked at that Froude number.
    const bool byFroude = formula == core::SquatFormula::Icorels || formula == core::SquatFormula::Yoshimura;
    const double speed_mps =
        speed_kn * core::kKnot_mps * (byFroude ? std::sqrt(core::kGravity_mps2 / 9.81) : 1.0);
    return core::squat_m(formula, {at("L"), at("B"), at("T"), at("Cb")}, speed_mps, at("h"),
                         std::isfinite(width_m) ? width_m : core::kOpenWater_m);
}

/// The ship in the first row at that depth.
report::XyPlot plotOf(const ReferenceTable& table) {
    report::XyPlot plot;
    plot.note = fmt::format("Of: {} in {} m.", table.text("ship", 0), table.text("h", 0));
    plot.xTitle = "speed, kn";
    plot.yTitle = "sinkage, m";
    report::XyPlot::Series published{"published", true, {}};
    for (const Formula& f : kFormulas) {
        report::XyPlot::Series line{f.name, false, {}};
        for (double speed_kn = 0.0; speed_kn <= 12.0; speed_kn += 0.25)
            line.at.emplace_back(speed_kn, squatOf(table, 0, f.formula, speed_kn));
        plot.series.push_back(std::move(line));
        for (std::size_t row = 0; row < table.rows(); ++row)
            if (table.text("ship", row) == table.text("ship", 0) && table.at("h", row) == table.at("h", 0))
                published.at.emplace_back(table.at("V_kn", row), table.at(f.column, row));
    }
    plot.series.push_back(std::move(published));
    return plot;
}

}  // namespace

ValidationOutcome runSquatCase(const ValidationContext& context, core::config::Reader& in) {
    const std::string file = in.text("file");
    const double share = readShare(in, "share");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    for (const Formula& f : kFormulas) {
        RelativeErrors errors;
        for (std::size_t row = 0; row < table->rows(); ++row)
            errors.add(squatOf(*table, row, f.formula, table->at("V_kn", row)), table->at(f.column, row));
        outcome.rows.push_back(largestErrorRow(f.name, errors, share));
    }
    outcome.plots.push_back(plotOf(*table));
    return outcome;
}

}  // namespace sagara::tools
