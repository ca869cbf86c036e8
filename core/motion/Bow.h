#pragma once

#include "core/motion/ShipMotion.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// Where the sea is watched at a ship's bow.
struct Bow {
    double stem_m = 0.0;           ///< the forward perpendicular, forward of midship
    double freeboard_m = 0.0;      ///< deck at the stem above the waterline
    double forefoot_m = 0.0;       ///< where the keel slams: a tenth of the length abaft the stem
    double draught_m = 0.0;        ///< there
    double slamThreshold_mps = 0;  ///< relative velocity above which a keel that comes in again slams
};
/// Height of the bow: the deck's, but at least what load lines ask for (ICLL 1966, regulation 39). Threshold
/// of slamming after Ochi (1964), 5th Symposium on Naval Hydrodynamics: 12 ft/s for 520 ft by Froude's law,
/// 0.0935 sqrt(g L).
Bow bowOf(const Hull& hull);

/// Rise of the water on a small ship-fixed mark on the centreline, from how it stands in calm water.
/// `elevation_m`: of the sea there, up positive.
double riseAt(const ShipMotion& m, double forward_m, double elevation_m);

}  // namespace sagara::core
