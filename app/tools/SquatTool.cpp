#include "app/tools/SquatTool.h"

#include <cmath>

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/base/Units.h"
#include "core/motion/Squat.h"

namespace sagara::tools {

int runSquatTool(const run::Store& store, const SquatToolOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    if (std::isinf(o.ship.depth_m))
        return run::tell("--depth-m: is missing; squat is of shallow water"), run::kBadRequest;
    const core::Hull& h = vessel->hull;
    const core::SquatHull hull{h.lengthBp_m, h.beam_m, h.draught_m, h.blockCoefficient()};
    const double width_m = o.width_m.value_or(core::kOpenWater_m);
    Table table({"speed_mps", "depth_over_draught", "depth_froude", "barrass_simple_m", "barrass_m",
                 "icorels_m", "yoshimura_m", "of_her_document_m"});
    for (const double speed_mps : o.speed_mps) {
        const auto squat = [&](core::SquatFormula formula) {
            return core::squat_m(formula, hull, speed_mps, o.ship.depth_m, width_m);
        };
        table.add({speed_mps, o.ship.depth_m / hull.draught_m,
                   speed_mps / std::sqrt(core::kGravity_mps2 * o.ship.depth_m),
                   squat(core::SquatFormula::BarrassSimple), squat(core::SquatFormula::Barrass),
                   squat(core::SquatFormula::Icorels), squat(core::SquatFormula::Yoshimura),
                   core::squatUnderWay_m(vessel->shallow.squat, hull, speed_mps, o.ship.depth_m)});
    }
    return writeResult(o.csv, table.text());
}

}  // namespace sagara::tools
