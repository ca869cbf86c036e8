#pragma once

#include <numbers>

/// Factors from the units people type to the SI units used inside core. Multiply to come in, divide to go
/// out: `speed_mps = 6 * kKnot_mps`, `heading_deg = heading_rad / kDegree_rad`.
namespace sagara::core {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
inline constexpr double kDegree_rad = kPi / 180.0;
inline constexpr double kNauticalMile_m = 1852.0;
inline constexpr double kCable_m = kNauticalMile_m / 10.0;
inline constexpr double kKnot_mps = kNauticalMile_m / 3600.0;
inline constexpr double kRpm_rps = 1.0 / 60.0;
inline constexpr double kShackle_m = 27.432;  ///< 15 fathoms, one length of anchor cable
inline constexpr double kTonne_kg = 1000.0;

inline constexpr double kGravity_mps2 = 9.80665;  ///< standard gravity, CGPM 1901
inline constexpr double kSeaWaterDensity_kgpm3 =
    1025.0;                                         ///< 15 degC, 35 per mille (ITTC 7.5-02-01-03: 1026.0)
inline constexpr double kAirDensity_kgpm3 = 1.225;  ///< ISO 2533 at sea level

}  // namespace sagara::core
