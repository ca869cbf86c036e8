#include "app/tools/CaseRows.h"
#include "app/tools/HullChoice.h"
#include "app/tools/ReferenceTable.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::tools {
namespace {

struct Quantity {
    const char* column;
    const char* name;
    double core::Hydrostatics::*value;
};
constexpr Quantity kQuantities[] = {{"volume", "volume, m3", &core::Hydrostatics::volume_m3},
                                    {"Aw", "waterplane, m2", &core::Hydrostatics::waterplane_m2},
                                    {"KB", "KB, m", &core::Hydrostatics::buoyancyHeight_m},
                                    {"BMT", "BM transverse, m", &core::Hydrostatics::transverseBM_m},
                                    {"BML", "BM longitudinal, m", &core::Hydrostatics::longitudinalBM_m},
                                    {"LCB", "LCB forward, m", &core::Hydrostatics::buoyancyForward_m}};

}  // namespace

ValidationOutcome runHydrostaticsCase(const ValidationContext& context, core::config::Reader& in) {
    const std::string hull = in.text("hull"), file = in.text("file"), name = in.text("row");
    const double share = readShare(in, "share");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto form = readHullFile(context.reference(hull).string());
    if (!form) return outcome.trouble = form.error(), outcome;
    const auto table = ReferenceTable::read(context.reference(file));
    if (!table) return outcome.trouble = table.error(), outcome;
    std::size_t row = 0;
    while (row < table->rows() && table->text("hull", row) != name) ++row;
    if (row == table->rows()) return outcome.trouble = file + ": has no row " + name, outcome;
    const core::Hydrostatics found = core::hydrostaticsOf(*form);
    for (const Quantity& q : kQuantities) {
        ValidationRow of;
        of.quantity = q.name;
        of.measured = found.*q.value;
        of.reference = table->at(q.column, row);
        of.share = of.reference != 0.0;  // a hull the same fore and aft has its LCB amidships
        of.tolerance = of.share ? share : 1e-6 * form->lengthBp_m;
        outcome.rows.push_back(of);
    }
    return outcome;
}

}  // namespace sagara::tools
