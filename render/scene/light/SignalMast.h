#pragma once

#include "render/scene/ship/ShipForm.h"

namespace sagara::render {

/// Where a ship carries lights and shapes above each other: annex I, sections 2 and 3. Heights above her
/// waterline.
struct SignalMast {
    double fore_m = 0.0;      ///< x of the forward masthead light
    double foreUp_m = 0.0;    ///< its height
    double main_m = 0.0;      ///< x of the after masthead light; of the only one when she has one
    double mainUp_m = 0.0;    ///< its height
    double sideUp_m = 0.0;    ///< height of the sidelights
    double spacing_m = 2.0;   ///< of lights in a vertical line
    double anchor_m = 0.0;    ///< x of the staff in the fore part for anchor light and ball
    double anchorUp_m = 0.0;  ///< height of the forward anchor light
    bool two = false;         ///< has two masthead lights, rule 23(a)(ii)
};
SignalMast signalMastOf(const ShipForm& form);

}  // namespace sagara::render
