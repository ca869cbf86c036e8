#pragma once

#include <array>
#include <cstddef>

namespace sagara::core {

inline constexpr std::size_t kMostShafts = 4;
inline constexpr std::size_t kMostThrusters = 4;

/// What the machinery does at this moment, as the hull feels it.
struct Actuators {
    double rudder_rad = 0.0;  ///< achieved, of all rudders; positive turns the bow to starboard
    std::array<double, kMostShafts> shaft_rps{};
    std::array<double, kMostShafts> pitch{1.0, 1.0, 1.0, 1.0};  ///< over the design pitch; fixed blades: 1
    /// Where an azimuth drive pushes the ship at positive shaft speed, clockwise from ahead.
    std::array<double, kMostShafts> azimuth_rad{};
    std::array<double, kMostThrusters> thruster{};  ///< share of the thrust at rest, starboard positive
};

}  // namespace sagara::core
