#pragma once

#include <string_view>

#include "core/vessel/Provenance.h"

namespace sagara::core {

/// Row of Blendermann (1994), J. Wind Eng. 51, 339-351: coefficients of a type of ship.
struct BlendermannType {
    std::string_view name;
    double transverseDrag;         ///< CDt
    double longitudinalDragBow;    ///< CDl,AF, wind from ahead
    double longitudinalDragStern;  ///< CDl,AF, wind from astern
    double crossForce;             ///< delta
    double rolling;                ///< kappa
};
/// The row of that name, or null.
const BlendermannType* findBlendermannType(std::string_view name);

/// What the wind sees.
struct Windage {
    BlendermannType type{};
    double frontalArea_m2 = 0.0;
    double lateralArea_m2 = 0.0;
    double centroidForward_m = 0.0;  ///< of the lateral area, forward of midship
    double centroidHeight_m = 0.0;   ///< above the waterline
    Provenance provenance;
};
Windage readWindage(config::Reader& in);

}  // namespace sagara::core
