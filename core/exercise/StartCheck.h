#pragma once

#include "core/base/Config.h"
#include "core/exercise/World.h"

namespace sagara::core {

/// Notes own ships that would start aground, on land, in a quay, or in another ship.
void checkStart(const World& world, config::Reader& scenario);

}  // namespace sagara::core
