#pragma once

#include <array>

#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/motion/Squat.h"
#include "core/vessel/Hull.h"
#include "core/world/Area.h"

namespace sagara::core {

/// Where the keel is looked at: ends, quarters of the breadth amidships. Immutable.
struct Keel {
    std::array<BodyPoint, 6> points;
    double draught_m = 0.0;
    SquatHull squat;
    SquatFormula formula = SquatFormula::BarrassSimple;
    double stiffness_Npm = 0.0;  ///< of one point: the waterplane's, shared out
};
Keel keelOf(const Hull& hull, double heaveStiffness_Npm, SquatFormula formula = SquatFormula::BarrassSimple);

/// Water under the keel where it is least: depth + tide - draught - squat, with heave, roll and pitch as they
/// are. Negative when she has run into the ground. `tide_m` above chart datum.
struct UnderKeel {
    double clearance_m = 0.0;
    BodyPoint point;
};
UnderKeel underKeel(const Area& area, const Keel& keel, const ShipMotion& m, double tide_m);

/// The ground's push up and its drag, once a point of the keel is in it: a spring that takes the ship's
/// weight, friction 0.5.
Load groundLoad(const Area& area, const Keel& keel, const ShipMotion& m, double tide_m, NorthEast current);

}  // namespace sagara::core
