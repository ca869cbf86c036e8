#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/seakeeping/RollDamping.h"

namespace sagara::tools {
namespace {

struct Part {
    const char* column;
    const char* name;
    double core::IkedaDamping::*value;
};
constexpr Part kParts[] = {{"BF", "friction", &core::IkedaDamping::friction},
                           {"BW", "waves", &core::IkedaDamping::wave},
                           {"BE", "eddies", &core::IkedaDamping::eddy},
                           {"BBK", "bilge keels", &core::IkedaDamping::bilgeKeel}};

core::IkedaDamping dampingOf(const ReferenceTable& table, std::size_t row) {
    const auto at = [&](const char* column) { return table.at(column, row); };
    const core::IkedaShip ship{at("Lpp"), at("B"),  at("d"),   at("CB"),
                               at("CM"),  at("OG"), at("lBK"), at("bBK")};
    // The table has g = 9.81: this frequency and viscosity undo that.
    const double shift = std::sqrt(core::kGravity_mps2 / 9.81);
    return core::ikedaDamping(ship, at("phi") * core::kDegree_rad, shift * at("w"), shift * 1.14e-6);
}

}  // namespace

ValidationOutcome runIkedaCase(const ValidationContext& context, core::config::Reader& in) {
    const std::string file = in.text("file");
    const double share = readShare(in, "share");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    for (const Part& part : kParts) {
        RelativeErrors errors;
        for (std::size_t row = 0; row < table->rows(); ++row)
            errors.add(dampingOf(*table, row).*part.value, table->at(part.column, row), 1e-6);
        outcome.rows.push_back(largestErrorRow(part.name, errors, share));
    }
    return outcome;
}

}  // namespace sagara::tools
