#pragma once

#include <cstddef>
#include <cstdint>

namespace sagara::core {

/// Who pushes an own ship in the horizontal plane.
enum class ForceCause : std::uint8_t { Hull, Rudder, Propeller, Wind, Waves, Lines, Anchors, Contact };
inline constexpr std::size_t kForceCauses = 8;

}  // namespace sagara::core
