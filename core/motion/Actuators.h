#pragma once

#include <array>
#include <cstddef>

namespace sagara::core {

inline constexpr std::size_t kMostShafts = 4;

/// What the machinery does at this moment, as the hull feels it.
struct Actuators {
    double rudder_rad = 0.0;  ///< achieved; positive turns the bow to starboard
    std::array<double, kMostShafts> shaft_rps{};
};

}  // namespace sagara::core
