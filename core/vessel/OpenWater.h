#pragma once

#include <optional>
#include <vector>

#include "core/base/Config.h"
#include "core/vessel/WageningenB.h"

namespace sagara::core {

/// KT = T / (rho n^2 D^4) and KQ = Q / (rho n^2 D^5).
struct OpenWaterPoint {
    double thrust = 0.0;
    double torque = 0.0;
};

/// Open-water characteristics of one propeller going ahead, at its design pitch, over the advance ratio
/// J = va / (n D): polynomials or a table.
struct OpenWater {
    struct Row {
        double J = 0.0;
        OpenWaterPoint at;
    };
    BScrew screw;                ///< blades, area and pitch: what the propeller is like in other quadrants
    std::vector<double> thrust;  ///< KT = c0 + c1 J + c2 J^2 ...
    std::vector<double> torque;  ///< KQ
    std::vector<Row> table;      ///< instead of both, where not empty; straight lines between rows

    OpenWaterPoint at(double J) const;
    /// The data hold from 0 to here: first J without thrust, or the end of the table.
    double highestJ() const;
};

/// Members of a propulsion unit that has four quadrants: "wageningenB" (blades, areaRatio, pitchRatio) and,
/// if wanted, "torqueCoefficients", or "openWater" (rows [J, KT, KQ]). KT is `thrust`, if given; what is not
/// given is that of the B-series.
OpenWater readOpenWater(config::Reader& unit, std::vector<double> thrust);

}  // namespace sagara::core
