#pragma once

#include "render/link/Check.h"
#include "render/link/Messages.h"
#include "render/link/Protocol.h"

namespace sagara::wire {
class Frame;
}

namespace sagara::link {

Kind write(const Frame& frame, wire::Frame& wire);
Frame read(const wire::Frame& wire, Check& check);

/// More than an exercise has, like kMostShips and kMostTargets.
inline constexpr std::size_t kMostSeaSystems = 64;

}  // namespace sagara::link
