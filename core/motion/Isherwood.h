#pragma once

#include "core/vessel/Windage.h"

namespace sagara::core {

/// Isherwood (1972), Trans. RINA 115, 327-338: regression on wind tunnel tests of merchant ships, about
/// midship. Cx on the frontal area, positive forward; Cy on the lateral area, positive away from the wind; Cn
/// on lateral area times length, positive when the bow turns away from the wind.
struct IsherwoodCoefficients {
    double Cx, Cy, Cn;
};
/// For a wind that far off the bow, either side, linear between the tabulated 10 degrees. `windage.isherwood`
/// must be there.
IsherwoodCoefficients isherwood(const Windage& windage, double lengthOverall_m, double fromBow_rad);

}  // namespace sagara::core
