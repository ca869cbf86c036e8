#pragma once

#include "core/motion/Load.h"
#include "core/sea/Wind.h"
#include "core/vessel/Hull.h"
#include "core/vessel/Windage.h"

namespace sagara::core {

/// Coefficients for a wind `fromBow_rad` off the bow, 0 ahead, positive when it comes from port, so that CY,
/// CK and CN are positive for a wind that pushes to starboard. Blendermann (1994), or Isherwood (1972) where
/// the vessel has his particulars; he gives no heel: his side force acts at the centroid of the lateral area.
struct WindCoefficients {
    double CX, CY, CK, CN;
};
WindCoefficients windCoefficients(const Windage& windage, double lengthOverall_m, double fromBow_rad);

/// Load of an apparent wind given by the velocity of the air relative to the ship, in B.
Load apparentWindLoad(const Windage& windage, double lengthOverall_m, BodyPoint air_mps);

/// Load of the true wind on a moving ship, less the load still air would make: the resistance of a hull
/// already holds that part. Zero in a calm at any speed. `ground_mps`: velocity of the ship over the ground,
/// in B.
Load windLoad(const Windage& windage, double lengthOverall_m, const WindVelocity& wind, double heading_rad,
              BodyPoint ground_mps);

}  // namespace sagara::core
