#include "app/tools/RaoTool.h"

#include <cmath>

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/base/Units.h"
#include "core/seakeeping/TimeDomain.h"

namespace sagara::tools {

int runRao(const run::Store& store, const RaoOptions& o) {
    const auto form = openHull(store, o.hull);
    if (!form) return run::tell(form.error()), run::kBadRequest;
    if (o.hull.ship.depth_m < core::kDeepWater_m)
        run::tell("rao: strip theory holds for deep water; --depth-m is not used");
    std::vector<double> omegas_radps = o.omegas_radps;
    for (const double lambda : o.lambdasOverLpp)
        omegas_radps.push_back(std::sqrt(core::kTwoPi * core::kGravity_mps2 / (lambda * form->lengthBp_m)));
    const double heading_rad = o.heading_deg * core::kDegree_rad;
    return writeResult(
        o.csv, o.timeDomain
                   ? core::timeDomainRaoTable(*form, o.speed_mps, heading_rad, omegas_radps, o.waveHeight_m)
                   : core::raoTable(*form, o.speed_mps, heading_rad, omegas_radps, o.waveHeight_m));
}

}  // namespace sagara::tools
