#pragma once

#include <string_view>

namespace sagara::core {

/// Names this build of core: sources, compiler and flags. Bit-equal replay is promised between equal ids
/// only.
std::string_view coreBuildId();

}  // namespace sagara::core
