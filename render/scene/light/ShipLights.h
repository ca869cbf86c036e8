#pragma once

#include <array>
#include <vector>

#include "core/world/Activity.h"
#include "render/scene/shape/Solid.h"
#include "render/scene/ship/ShipForm.h"

namespace sagara::render {

/// One navigation light: where it stands and over which arc it shows (COLREG rules 21 and 22, annex I).
struct ShipLight {
    Point position;                ///< in the ship's frame
    std::array<double, 3> colour;  ///< as the screen gets it
    double from_rad;               ///< arc, clockwise, relative to the bow
    double to_rad;
    double range_M;

    /// Share of its strength seen from this relative bearing; it falls to nothing within 3 deg outside the
    /// arc.
    double seenFrom(double relativeBearing_rad) const;
};

/// Lights she shows at night, after rules 23 to 30. `makingWay`: through the water; who fishes, is not under
/// command or restricted shows no side and stern lights without it.
std::vector<ShipLight> lightsOf(const ShipForm& form, core::Activity activity, bool makingWay = true);

}  // namespace sagara::render
