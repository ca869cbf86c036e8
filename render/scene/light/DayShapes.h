#pragma once

#include <vector>

#include "core/world/Activity.h"
#include "render/scene/shape/Solid.h"
#include "render/scene/ship/ShipForm.h"

namespace sagara::render {

/// A black shape hoisted by day: COLREG annex I, section 6.
struct DayShape {
    enum class Kind { Ball, ConeUp, ConeDown, Diamond } kind = Kind::Ball;  ///< cones: where the apex is
    Point centre;                                                           ///< in the ship's frame
    double diameter_m = 0.6;

    double height_m() const { return kind == Kind::Diamond ? 2.0 * diameter_m : diameter_m; }
};

/// Shapes above each other, from the top down, and the staff or halyard they hang on.
struct DayHoist {
    std::vector<DayShape> shapes;  ///< empty for most ships
    double footUp_m = 0.0;
    double headUp_m = 0.0;
};
/// What rules 24 to 30 ask for.
DayHoist dayHoistOf(const ShipForm& form, core::Activity activity);

/// It as a solid about the lowest shape's centre, upright.
Solid solidOf(const DayHoist& hoist);

}  // namespace sagara::render
