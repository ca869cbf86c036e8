#pragma once

#include <vector>

#include "core/base/Config.h"
#include "core/sea/Spectrum.h"

namespace sagara::core {

/// "sea" of a scenario's weather, instead of the one that follows from the wind. "spectrum" chooses what else
/// is read: "pierson-moskowitz" with "wind_kn"; "bretschneider" with "height_m" and "period_s" (peak); "ittc"
/// with "height_m" and "meanPeriod_s"; "jonswap" with "height_m", "period_s" and "gamma" (3.3); "ochi-hubble"
/// with "height_m"; "beaufort" with "number" and "exposure"; "measured" with "record" (see readBuoySpectrum).
/// All but the last have "from_deg", "spreading" (4) and "spreadingLaw" (cos2s, or cosN).
std::vector<SeaSystem> readSea(config::Reader& in);

}  // namespace sagara::core
