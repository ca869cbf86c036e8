#pragma once

#include <array>
#include <vector>

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

enum class ShipActivity { UnderWay, Anchored, Moored };

/// Lights she shows. Yachts are taken to be sailing, unless a masthead light is placed.
std::vector<ShipLight> lightsOf(const ShipForm& form, ShipActivity activity);

}  // namespace sagara::render
