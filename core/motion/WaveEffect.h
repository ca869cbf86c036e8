#pragma once

#include "core/motion/HeightMotion.h"
#include "core/seakeeping/WaveExcitation.h"

namespace sagara::core {

/// What waves do to a ship at her place, for the models that feel their pressure or are pushed by their
/// heights; nothing of either for those that know no waves.
struct WaveEffect {
    WaveForces forces;
    Load wetted;  ///< heave, roll and pitch: what the hull as she is wetted has more than her mean hull
    WaveHeights heights;
};

/// First-order and mean force together.
inline Load waveLoad(const WaveEffect& waves) {
    const Six &first = waves.forces.first, &mean = waves.forces.mean;
    return Load{first[0] + mean[0], first[1] + mean[1], first[2], first[3], first[4], first[5] + mean[5]} +
           waves.wetted;
}
inline Load meanForce(const WaveForces& waves) {
    return {.surge_N = waves.mean[0], .sway_N = waves.mean[1], .yaw_Nm = waves.mean[5]};
}

}  // namespace sagara::core
