#pragma once

#include <optional>
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

/// What Isherwood's regression asks for beyond the areas.
struct IsherwoodParticulars {
    double perimeter_m = 0.0;                   ///< S, of the lateral projection less the waterline
    double superstructureLateralArea_m2 = 0.0;  ///< ASS
    int mastGroups = 0;                         ///< M, masts and king posts in the lateral projection
    double beam_m = 0.0;                        ///< that of the hull
};

/// What the wind sees.
struct Windage {
    BlendermannType type{};
    double frontalArea_m2 = 0.0;
    double lateralArea_m2 = 0.0;
    double centroidForward_m = 0.0;  ///< of the lateral area, forward of midship
    double centroidHeight_m = 0.0;   ///< above the waterline
    Provenance provenance;
    std::optional<IsherwoodParticulars> isherwood;  ///< given: Isherwood (1972) makes the loads
};
/// "method" is "blendermann1994" (if absent too) with "blendermannType", or "isherwood1972" with
/// "perimeter_m", "superstructureLateralArea_m2" and "mastGroups".
Windage readWindage(config::Reader& in);

}  // namespace sagara::core
