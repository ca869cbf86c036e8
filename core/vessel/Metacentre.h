#pragma once

#include "core/vessel/Hull.h"

namespace sagara::core {

/// Centre of gravity below the waterline at which a hull has her metacentric height: KB by Morrish, BM of a
/// waterplane of her coefficient (see estimate::Form). Above the waterline it is negative.
double gravityDepth_m(const Hull& hull);

}  // namespace sagara::core
