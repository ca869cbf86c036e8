#pragma once

#include "core/motion/MmgPropeller.h"

namespace sagara::core {

/// Side force and yawing moment of a single screw that drives astern, by reversed turning or reversed pitch:
/// its rotating wash meets the stern on one side above and on the other below. By the rows of the document,
/// straight between them; with reversed pitch at the turns that would give its thrust at the design pitch. A
/// right-handed screw takes the stern to port. Nothing without rows or while it drives ahead. In the plane of
/// midship; heels at half the draught.
Load asternSideForce(const std::vector<AsternSideRow>& rows, const Hull& hull, const PropulsionUnit& unit,
                     const ScrewOrder& order, double surge_mps);

}  // namespace sagara::core
