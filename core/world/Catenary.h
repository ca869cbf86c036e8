#pragma once

namespace sagara::core {

/// An anchor cable at rest: from the hawse `height_m` above the ground, `horizontal_m` away from the anchor,
/// `length_m` out.
struct CableShape {
    double horizontal_N = 0.0;  ///< pull on the ship, and on the ground where cable lies
    double atHawse_N = 0.0;     ///< tension at the top
    double lying_m = 0.0;       ///< cable on the ground
    double uplift_rad = 0.0;    ///< of the cable at the anchor; 0 while any of it lies
};

/// Elastic catenary in still water with part of it on the ground (Faltinsen 1990, section 8). `weight_Npm` in
/// water; `stiffness_N` = EA. Zero pull while the cable hangs up and down. Lengths positive; horizontal_m may
/// exceed length_m: the cable then stretches.
CableShape cableShape(double horizontal_m, double height_m, double length_m, double weight_Npm,
                      double stiffness_N);

}  // namespace sagara::core
