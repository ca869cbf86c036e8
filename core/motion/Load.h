#pragma once

#include "core/base/Planar.h"

namespace sagara::core {

/// Force and moment on a ship in frame B about Bo (midship, centreline, waterline). z down, so heave_N is
/// downward; roll positive starboard down, pitch positive bow up, yaw positive bow to starboard.
struct Load {
    double surge_N = 0.0;
    double sway_N = 0.0;
    double heave_N = 0.0;
    double roll_Nm = 0.0;
    double pitch_Nm = 0.0;
    double yaw_Nm = 0.0;
};

/// Who pushes, of the parts that belong to the ship.
struct HullForces {
    Load hull;
    Load rudder;
    Load propeller;
};

inline Load operator+(const Load& a, const Load& b) {
    return {a.surge_N + b.surge_N, a.sway_N + b.sway_N,     a.heave_N + b.heave_N,
            a.roll_Nm + b.roll_Nm, a.pitch_Nm + b.pitch_Nm, a.yaw_Nm + b.yaw_Nm};
}
inline Load operator*(double s, const Load& a) {
    return {s * a.surge_N, s * a.sway_N, s * a.heave_N, s * a.roll_Nm, s * a.pitch_Nm, s * a.yaw_Nm};
}

/// A horizontal force (its components given as a vector of B) that acts at a point `height_m` above the
/// waterline.
inline Load forceAt(BodyPoint point, double height_m, BodyPoint force_N) {
    return {.surge_N = force_N.x_m,
            .sway_N = force_N.y_m,
            .roll_Nm = height_m * force_N.y_m,
            .pitch_Nm = -height_m * force_N.x_m,
            .yaw_Nm = point.x_m * force_N.y_m - point.y_m * force_N.x_m};
}

}  // namespace sagara::core
