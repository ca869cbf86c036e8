#include "core/world/Hostile.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

constexpr double kNotice_m = 1852.0;
constexpr double kHarass_m = 400.0;
constexpr double kStandOff_m = 160.0;
constexpr double kTooNear_m = 120.0;
constexpr double kHarassTime_s = 240.0;
constexpr double kRestTime_s = 180.0;
constexpr double kLoiterRadius_m = 150.0;

double fastest_mps(const TargetLayout& layout) {
    double speed = 0.0;
    for (const auto& waypoint : layout.route) speed = std::max(speed, waypoint.speed_mps);
    return speed;
}

void enter(TargetState& state, HostilePhase phase) {
    state.phase = phase;
    state.phaseTime_s = 0.0;
}

void choosePhase(TargetState& state, double range_m) {
    switch (state.phase) {
        case HostilePhase::Loiter:
            if (range_m < kNotice_m) enter(state, HostilePhase::Close);
            break;
        case HostilePhase::Close:
            if (range_m < kHarass_m) enter(state, HostilePhase::Harass);
            if (range_m > 2.0 * kNotice_m) enter(state, HostilePhase::Loiter);
            break;
        case HostilePhase::Harass:
            if (state.phaseTime_s > kHarassTime_s) enter(state, HostilePhase::Withdraw);
            if (range_m > 2.0 * kHarass_m) enter(state, HostilePhase::Close);
            break;
        case HostilePhase::Withdraw:
            if (state.phaseTime_s > kRestTime_s) enter(state, HostilePhase::Loiter);
            break;
    }
}

/// Round a point clockwise at a radius: steer along the circle, and towards it when off it.
double headingRound(NorthEast centre, NorthEast p, double radius_m) {
    const double outward_rad = bearing_rad(centre, p);
    const double off = std::clamp((distance(centre, p) - radius_m) / radius_m, -1.0, 1.0);
    return outward_rad + kPi / 2 + off * kPi / 3;
}

}  // namespace

TargetIntent hostileIntent(const TargetLayout& layout, TargetState& state, NorthEast ownPosition,
                           double ownHeading_rad, double ownSpeed_mps, double dt_s) {
    const double range_m = distance(state.position, ownPosition);
    state.phaseTime_s += dt_s;
    choosePhase(state, range_m);
    const double fast = fastest_mps(layout);
    const auto atLeast = [&](double speed_mps) { return std::clamp(speed_mps, 0.6 * fast, fast); };
    if (range_m < kTooNear_m) return {bearing_rad(ownPosition, state.position), atLeast(ownSpeed_mps + 3.0)};
    switch (state.phase) {
        case HostilePhase::Close: {
            // for a point ahead of her bow
            const NorthEast ahead =
                ownPosition + (kStandOff_m + 20.0 * ownSpeed_mps) * unitVector(ownHeading_rad);
            return {bearing_rad(state.position, ahead), fast};
        }
        case HostilePhase::Harass:
            return {headingRound(ownPosition, state.position, kStandOff_m), atLeast(1.5 * ownSpeed_mps)};
        case HostilePhase::Withdraw:
            return {bearing_rad(state.position, state.home), 0.8 * fast};
        case HostilePhase::Loiter:
            break;
    }
    return {headingRound(state.home, state.position, kLoiterRadius_m), 0.25 * fast};
}

}  // namespace sagara::core
