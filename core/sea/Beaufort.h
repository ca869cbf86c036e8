#pragma once

#include <optional>
#include <string_view>

#include "core/sea/Spectrum.h"

namespace sagara::core {

/// Where the wind sea grows: the open ocean, or coastal waters with a limited fetch.
enum class Exposure { Ocean, Inshore };

inline constexpr int kBeaufortMax = 12;

/// Number of the Beaufort scale for a mean wind at 10 m: WMO limits.
int beaufortOfWind(double speed_mps);
/// "calm", "light air", ... "hurricane". Number 0 to 12.
std::string_view beaufortName(int number);
/// Middle of the number's wind band, WMO; for 12 its lower limit.
double windOfBeaufort_mps(int number);

/// The sea that belongs to a wind: significant height and mean period T1 by Beaufort number (Journee and
/// Massie, open ocean: Bretschneider; inshore: JONSWAP with gamma 3.3), interpolated between the middles of
/// the bands. Number 0 is no waves at all; below the middle of band 1 the sea fades to nothing.
std::optional<WaveSystem> windSea(double speed_mps, double windFrom_rad, Exposure exposure);

}  // namespace sagara::core
