#include "render/scene/sea/Wake.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

constexpr double kSlowest_mps = 0.6;

struct Step {
    core::NorthEast middle;
    core::NorthEast right;  ///< unit vector to starboard of the ribbon
    double along_m, halfWidth_m, strength;
};

void add(FoamRibbon& ribbon, const Step& s) {
    for (const double side : {-1.0, 1.0})
        ribbon.push_back(
            {s.middle + (side * s.halfWidth_m) * s.right, side, s.along_m, s.strength, 2.0 * s.halfWidth_m});
}

/// Where her stern was, back along her circle.
FoamRibbon wake(const ShipPose& pose, double length_m, double beam_m) {
    const double speed = pose.speedThroughWater_mps;
    const double reach_m = std::min(70.0 * speed, 9.0 * length_m);
    const double strength = std::clamp(0.25 + 0.09 * speed, 0.0, 1.0);
    constexpr int kSteps = 26;
    FoamRibbon ribbon;
    core::NorthEast p = core::HeadingFrame(pose.position, pose.heading_rad).point({-0.42 * length_m, 0.0});
    double heading = pose.heading_rad, along_m = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        add(ribbon, {p, core::turnedRight(core::unitVector(heading)), along_m,
                     0.42 * beam_m + 0.035 * along_m, strength * (1.0 - share) * (1.0 - share)});
        // Short steps near the ship, long ones far away.
        const double step_m = reach_m * 2.0 * (share + 0.5 / kSteps) / kSteps;
        const double turn = speed > 0.0 ? step_m * pose.yawRate_radps / speed : 0.0;
        p = p + (-step_m) * core::unitVector(heading - 0.5 * turn);
        heading -= turn;
        along_m += step_m;
    }
    return ribbon;
}

/// From the stem outward and aft at the angle of a ship's bow wave.
FoamRibbon bowWave(const ShipPose& pose, double length_m, double beam_m, double side) {
    const double froude = pose.speedThroughWater_mps / std::sqrt(core::kGravity_mps2 * length_m);
    const double strength = std::clamp(3.2 * froude, 0.0, 1.0);
    const core::HeadingFrame ship(pose.position, pose.heading_rad);
    constexpr int kSteps = 10;
    FoamRibbon ribbon;
    for (int i = 0; i <= kSteps; ++i) {
        const double f = static_cast<double>(i) / kSteps, along_m = 0.9 * length_m * f;
        const double x = 0.46 * length_m - along_m;
        const double y = 0.5 * beam_m * std::min(1.0, 2.2 * std::sqrt(f)) + 0.18 * along_m;
        add(ribbon, {ship.point({x, side * y}), ship.vector({0.0, side}), along_m,
                     (0.02 + 0.05 * f) * length_m * (0.4 + 1.2 * froude), strength * (1.0 - f)});
    }
    return ribbon;
}

}  // namespace

std::vector<FoamRibbon> foamOf(const ShipPose& pose, double length_m, double beam_m) {
    if (pose.speedThroughWater_mps < kSlowest_mps) return {};
    return {wake(pose, length_m, beam_m), bowWave(pose, length_m, beam_m, -1.0),
            bowWave(pose, length_m, beam_m, 1.0)};
}

}  // namespace sagara::render
