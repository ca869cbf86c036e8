#include "core/motion/WindLoad.h"

#include <cmath>

#include "core/base/Units.h"
#include "core/motion/Isherwood.h"

namespace sagara::core {

WindCoefficients windCoefficients(const Windage& windage, double lengthOverall_m, double fromBow_rad) {
    const BlendermannType& type = windage.type;
    const double g = std::abs(fromBow_rad), side = fromBow_rad < 0.0 ? -1.0 : 1.0;
    const double meanHeight_m = windage.lateralArea_m2 / lengthOverall_m;
    if (windage.isherwood) {
        const IsherwoodCoefficients c = isherwood(windage, lengthOverall_m, fromBow_rad);
        return {c.Cx, side * c.Cy, side * c.Cy * windage.centroidHeight_m / meanHeight_m, side * c.Cn};
    }
    const double longitudinal =
        std::abs(g) <= kPi / 2 ? type.longitudinalDragBow : type.longitudinalDragStern;
    const double lateralAreaRatio = windage.frontalArea_m2 / windage.lateralArea_m2;
    const double ratio = longitudinal * lateralAreaRatio / type.transverseDrag;
    const double sin2g = std::sin(2.0 * g);
    const double denominator = 1.0 - 0.5 * type.crossForce * (1.0 - ratio) * sin2g * sin2g;
    const double CY = type.transverseDrag * std::sin(g) / denominator;
    return {.CX = -longitudinal * std::cos(g) / denominator,
            .CY = side * CY,
            .CK = side * type.rolling * windage.centroidHeight_m / meanHeight_m * CY,
            .CN = side * (windage.centroidForward_m / lengthOverall_m - 0.18 * (g - kPi / 2)) * CY};
}

Load apparentWindLoad(const Windage& windage, double lengthOverall_m, BodyPoint air_mps) {
    const double speed2 = air_mps.x_m * air_mps.x_m + air_mps.y_m * air_mps.y_m;
    if (speed2 < 1e-12) return {};
    // air that moves to starboard comes from port
    const WindCoefficients c =
        windCoefficients(windage, lengthOverall_m, std::atan2(air_mps.y_m, -air_mps.x_m));
    const double pressure_Pa = 0.5 * kAirDensity_kgpm3 * speed2;
    const double lateral_N = pressure_Pa * windage.lateralArea_m2;
    return {.surge_N = pressure_Pa * windage.frontalArea_m2 * c.CX,
            .sway_N = lateral_N * c.CY,
            .roll_Nm = lateral_N * windage.lateralArea_m2 / lengthOverall_m * c.CK,
            .yaw_Nm = lateral_N * lengthOverall_m * c.CN};
}

Load windLoad(const Windage& windage, double lengthOverall_m, const WindVelocity& wind, double heading_rad,
              BodyPoint ground_mps) {
    const double toRelative_rad = wind.windFrom_rad + kPi - heading_rad;
    const BodyPoint still{-ground_mps.x_m, -ground_mps.y_m};
    const BodyPoint air{wind.speed_mps * std::cos(toRelative_rad) + still.x_m,
                        wind.speed_mps * std::sin(toRelative_rad) + still.y_m};
    return apparentWindLoad(windage, lengthOverall_m, air) +
           -1.0 * apparentWindLoad(windage, lengthOverall_m, still);
}

}  // namespace sagara::core
