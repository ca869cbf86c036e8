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

/// Shapes of rules 24 to 30, from the top down; empty for most.
std::vector<DayShape> dayShapesOf(const ShipForm& form, core::Activity activity);

/// Them and what they hang on, about the lowest one's centre, upright.
Solid hoistOf(const std::vector<DayShape>& shapes);

}  // namespace sagara::render
