#pragma once

#include <string>
#include <string_view>

#include "core/base/Problems.h"
#include "core/base/Result.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// What shows of a vessel only when she moves: full ahead and full astern in deep calm water, and a little
/// wheel to starboard, with each of her models, up to the first that has problems. Named as problems of her
/// document, with the numbers: speed out of reach of her length or of her engines' torque, resistance below
/// friction or beyond what a hull has, no way astern, turning the wrong way, a model that leaves the numbers.
/// Takes some tens of milliseconds.
config::Problems problemsAtSea(const std::string& name, const Vessel& vessel);

/// A document that loads and whose vessel sails: for those who check what somebody wrote. Exercises load
/// vessels with loadVessel.
Result<Vessel, config::Problems> loadSeaworthy(const std::string& name, std::string_view text);

}  // namespace sagara::core
