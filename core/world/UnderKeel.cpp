#include "core/world/UnderKeel.h"

#include <cmath>

namespace sagara::core {
namespace {

/// Under one point of the keel, squat not taken off.
double clearanceAt(const Area& area, const Keel& keel, const ShipMotion& m, const HeadingFrame& frame,
                   BodyPoint p, double tide_m) {
    const double keel_m = keel.draught_m + m.down_m - p.x_m * m.pitch_rad + p.y_m * m.roll_rad;
    return area.depth_m(frame.point(p)) + tide_m - keel_m;
}

}  // namespace

Keel keelOf(const Hull& hull, double heaveStiffness_Npm, SquatFormula formula) {
    const double x = 0.45 * hull.lengthBp_m, y = 0.3 * hull.beam_m;
    const std::array<BodyPoint, 6> points{
        {{x, 0.0}, {0.5 * x, y}, {0.5 * x, -y}, {-0.5 * x, y}, {-0.5 * x, -y}, {-x, 0.0}}};
    return {points,
            hull.draught_m,
            {hull.lengthBp_m, hull.beam_m, hull.draught_m, hull.blockCoefficient()},
            formula,
            heaveStiffness_Npm / static_cast<double>(points.size())};
}

UnderKeel underKeel(const Area& area, const Keel& keel, const ShipMotion& m, double tide_m) {
    const HeadingFrame frame(m.position(), m.heading_rad);
    UnderKeel least{1e9, {}};
    for (const BodyPoint& p : keel.points) {
        const double clearance_m = clearanceAt(area, keel, m, frame, p, tide_m);
        if (clearance_m < least.clearance_m) least = {clearance_m, p};
    }
    const double depth_m = least.clearance_m + keel.draught_m;
    least.clearance_m -=
        squatUnderWay_m(keel.formula, keel.squat, std::hypot(m.surge_mps, m.sway_mps), depth_m);
    return least;
}

Load groundLoad(const Area& area, const Keel& keel, const ShipMotion& m, double tide_m, NorthEast current) {
    constexpr double kFriction = 0.5, kFrictionSpeed_mps = 0.05;
    const HeadingFrame frame(m.position(), m.heading_rad);
    Load sum;
    for (const BodyPoint& p : keel.points) {
        const double clearance_m = clearanceAt(area, keel, m, frame, p, tide_m);
        if (clearance_m >= 0.0) continue;
        const double up_N = -clearance_m * keel.stiffness_Npm;
        const NorthEast velocity = frame.vector(velocityAt(m, p)) + current;
        const double drag = kFriction * up_N / (length(velocity) + kFrictionSpeed_mps);
        sum = sum + forceAt(p, 0.0, frame.vectorInBody(-drag * velocity)) +
              Load{.heave_N = -up_N, .roll_Nm = -p.y_m * up_N, .pitch_Nm = p.x_m * up_N};
    }
    return sum;
}

}  // namespace sagara::core
