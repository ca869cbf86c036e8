#include <fmt/format.h>

#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/motion/WindLoad.h"

namespace sagara::tools {
namespace {

/// A windage described by a row of the table, and her length over all.
struct WindRow {
    core::Windage windage;
    double length_m = 0.0;
};
using ReadWindRow = WindRow (*)(const ReferenceTable& table, std::size_t row);

WindRow isherwoodRow(const ReferenceTable& table, std::size_t row) {
    const auto at = [&](const char* column) { return table.at(column, row); };
    core::Windage w;
    w.frontalArea_m2 = at("AT");
    w.lateralArea_m2 = at("AL");
    w.centroidForward_m = 0.5 * at("L") - at("C");
    w.isherwood = core::IsherwoodParticulars{at("S"), at("ASS"), static_cast<int>(at("M")), at("B")};
    return {w, at("L")};
}

WindRow blendermannRow(const ReferenceTable& table, std::size_t row) {
    const auto at = [&](const char* column) { return table.at(column, row); };
    core::Windage w;
    if (const auto* type = core::findBlendermannType(table.text("type", row))) w.type = *type;
    w.frontalArea_m2 = at("AF");
    w.lateralArea_m2 = at("AL");
    w.centroidForward_m = at("sL");
    w.centroidHeight_m = at("sH");
    return {w, at("Loa")};
}

/// A coefficient, the columns that may hold it (Blendermann's and Isherwood's) and whether both have it.
struct Coefficient {
    const char* blendermann;
    const char* isherwood;
    double core::WindCoefficients::*value;
};
constexpr Coefficient kCoefficients[] = {{"CX", "Cx", &core::WindCoefficients::CX},
                                         {"CY", "Cy", &core::WindCoefficients::CY},
                                         {"CK", "", &core::WindCoefficients::CK},
                                         {"CN", "Cn", &core::WindCoefficients::CN}};

/// Coefficients of the ship in the first row over the wind's direction.
report::XyPlot plotOf(const ReferenceTable& table, ReadWindRow read, bool isherwood) {
    const WindRow ship = read(table, 0);
    const std::string name = table.text(isherwood ? "ship" : "type", 0);
    report::XyPlot plot;
    plot.note = fmt::format("Of: {}.", name);
    plot.xTitle = "wind off the bow, deg";
    plot.yTitle = "coefficient";
    for (const Coefficient& c : kCoefficients) {
        if (isherwood && !*c.isherwood) continue;
        report::XyPlot::Series line{c.blendermann, false, {}};
        for (int angle_deg = 0; angle_deg <= 180; angle_deg += 2)
            line.at.emplace_back(
                angle_deg,
                core::windCoefficients(ship.windage, ship.length_m, angle_deg * core::kDegree_rad).*c.value);
        plot.series.push_back(std::move(line));
    }
    report::XyPlot::Series published{"published", true, {}};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(isherwood ? "ship" : "type", row) != name) continue;
        for (const Coefficient& c : kCoefficients)
            if (!isherwood || *c.isherwood)
                published.at.emplace_back(table.at("angle", row),
                                          table.at(isherwood ? c.isherwood : c.blendermann, row));
    }
    plot.series.push_back(std::move(published));
    return plot;
}

}  // namespace

ValidationOutcome runWindCase(const ValidationContext& context, core::config::Reader& in) {
    const bool isherwood = in.choice<bool>("method", {{"isherwood1972", true}, {"blendermann1994", false}});
    const std::string file = in.text("file");
    const double share = readShare(in, "share");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    const ReadWindRow read = isherwood ? isherwoodRow : blendermannRow;
    for (const Coefficient& c : kCoefficients) {
        if (isherwood && !*c.isherwood) continue;
        RelativeErrors errors;
        for (std::size_t row = 0; row < table->rows(); ++row) {
            const WindRow ship = read(*table, row);
            const double found = core::windCoefficients(ship.windage, ship.length_m,
                                                        table->at("angle", row) * core::kDegree_rad).*
                                 c.value;
            // Zeros of the table are the roundings of sines: errors there are those over a thousandth.
            errors.add(found, table->at(isherwood ? c.isherwood : c.blendermann, row), 1e-3);
        }
        outcome.rows.push_back(largestErrorRow(c.blendermann, errors, share));
    }
    outcome.plots.push_back(plotOf(*table, read, isherwood));
    return outcome;
}

}  // namespace sagara::tools
