#pragma once

#include <vector>

#include "core/base/Config.h"
#include "core/base/LocalFrame.h"
#include "core/world/Target.h"

namespace sagara::core {

/// "traffic" of a scenario.
std::vector<TargetLayout> readTraffic(config::Reader& scenario, const LocalFrame& frame);

}  // namespace sagara::core
