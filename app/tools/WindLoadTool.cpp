#include "app/tools/WindLoadTool.h"

#include <cmath>

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/base/Angle.h"
#include "core/motion/WindLoad.h"

namespace sagara::tools {

int runWindLoad(const run::Store& store, const WindLoadOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    std::vector<double> from_deg = o.from_deg;
    for (int i = 0; o.from_deg.empty() && i <= 18; ++i) from_deg.push_back(10.0 * i);
    const double length_m = vessel->hull.lengthOverall_m;
    Table table({"from_deg", "CX", "CY", "CK", "CN", "surge_N", "sway_N", "roll_Nm", "yaw_Nm"});
    for (const double angle_deg : from_deg) {
        const double from_rad = core::wrapPi(angle_deg * core::kDegree_rad);
        const core::WindCoefficients c = core::windCoefficients(vessel->windage, length_m, -from_rad);
        const core::Load load = core::apparentWindLoad(
            vessel->windage, length_m, {-o.wind_mps * std::cos(from_rad), -o.wind_mps * std::sin(from_rad)});
        table.add({angle_deg, c.CX, c.CY, c.CK, c.CN, load.surge_N, load.sway_N, load.roll_Nm, load.yaw_Nm});
    }
    return writeResult(o.csv, table.text());
}

}  // namespace sagara::tools
