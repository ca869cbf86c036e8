#pragma once

#include "core/motion/Load.h"

namespace sagara::core {

/// A ship as the water round her feels her: slender, with a parabolic curve of section areas.
struct SlenderShip {
    NorthEast position;
    double heading_rad = 0.0;
    double surge_mps = 0.0;  ///< through the water
    double sway_mps = 0.0;   ///< the same
    double length_m = 0.0;
    double beam_m = 0.0;
    double displacement_m3 = 0.0;
};

/// Load on `own` in her frame of the water that `other` moves: surge, sway and yaw. Slender-body theory for
/// the double body (Tuck and Newman 1974, 10th Symp. Naval Hydrodynamics; Wang 1975 for a ship that lies
/// still): the other's line of sources, with its images in the ground (depth_m), makes a stream along own's
/// centreline, and each section of own feels the change of its momentum,
/// dY = rho {(d/dt - U d/dx)[S v] + S (d/dt - U d/dx) v} dx, little of the first d/dx on the afterbody, where
/// the cross flow leaves the hull (Jones 1946). Any courses and speeds; no free-surface waves. Nothing beyond
/// twice the sum of both lengths, and of a ship of less than a thousandth of own's size.
Load interactionLoad(const SlenderShip& own, const SlenderShip& other, double depth_m,
                     double waterDensity_kgpm3);

}  // namespace sagara::core
