#pragma once

#include <vector>

#include "core/base/Config.h"
#include "core/base/LocalFrame.h"
#include "core/world/Target.h"

namespace sagara::core {

/// "type" of a traffic ship.
TargetType readTargetType(config::Reader& in);

/// "traffic" of a scenario.
std::vector<TargetLayout> readTraffic(config::Reader& scenario, const LocalFrame& frame);

}  // namespace sagara::core
