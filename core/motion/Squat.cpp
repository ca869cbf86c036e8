#include "core/motion/Squat.h"

#include <algorithm>

#include "core/base/Units.h"

namespace sagara::core {

double squat_m(double blockCoefficient, double speedThroughWater_mps, double depth_m, double draught_m) {
    const double speed_kn = speedThroughWater_mps / kKnot_mps;
    const double shallow = std::clamp((2.5 - depth_m / draught_m) / (2.5 - 1.4), 0.0, 1.0);
    return shallow * blockCoefficient * speed_kn * speed_kn / 100.0;
}

}  // namespace sagara::core
