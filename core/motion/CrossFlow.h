#pragma once

#include "core/motion/Load.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// Drag of a hull that drifts and swings with little or no way on: each of 12 strips along the length resists
/// its own lateral speed, 1/2 rho Cd T v|v| (cross-flow principle; Faltinsen 1990, section 7). For ships near
/// rest; under way the derivatives of the manoeuvring model hold.
Load crossFlowDrag(const Hull& hull, double dragCoefficient, double sway_mps, double yawRate_radps);

}  // namespace sagara::core
