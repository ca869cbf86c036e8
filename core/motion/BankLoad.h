#pragma once

#include "core/motion/Load.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// Suction to the nearer bank and cushion at the bow: Norrbin (1974), Proc. 10th Symp. Naval Hydrodynamics,
/// vertical walls: Y = (m U^2/L)(0.0926 + 0.372 (T/h)^2) eta, N = m U^2 (0.025 + 0.0755 (T/h)^2) eta, here
/// with eta = B/2 (1/y_starboard - 1/y_port), y from the centreline to the walls: force positive to starboard
/// where that is the nearer bank, and the bow turned to port. Where less than 15 % of the draught is left
/// under the keel the suction falls, at 10 % it is gone, below it turns to a push off (Vantorre,
/// Verzhbitskaya and Laforce 2002, as a trend).
Load bankLoad(const Hull& hull, double eta, double surge_mps, double depth_m);

}  // namespace sagara::core
