#include "core/motion/MmgRudderForce.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/SmoothStep.h"

namespace sagara::core {
namespace {

constexpr double kSuction = 0.5;    ///< of the race's build-up, on the side a screw draws from
constexpr double kFromAft = 0.6;    ///< lift with the trailing edge to the flow
constexpr double kFlatPlate = 1.2;  ///< normal force coefficient across the flow
constexpr double kStallOver_rad = 15.0 * kDegree_rad;

double signedSquare(double x) { return x * std::abs(x); }
double signedRoot(double x) { return std::copysign(std::sqrt(std::abs(x)), x); }

/// Eq 22 written without division by the advance ratio, so that it holds at rest and astern.
double inflowAlong_mps(const MmgRudder& k, const PropulsionUnit& unit, const MmgPropeller& screw, bool inRace,
                       double density_kgpm3) {
    const double before_mps = screw.inflow_mps;
    if (!inRace) return k.epsilon * before_mps;
    const double eta = std::min(1.0, unit.diameter_m / k.height_m);
    const double loading = 8.0 * screw.thrust_N / (density_kgpm3 * kPi * unit.diameter_m * unit.diameter_m);
    const double race_mps = signedRoot(signedSquare(before_mps) + loading);
    const double kappa = screw.thrust_N >= 0.0 ? k.kappa : kSuction * k.kappa;
    const double inside_mps = before_mps + kappa * (race_mps - before_mps);
    return k.epsilon * signedRoot(eta * signedSquare(inside_mps) + (1.0 - eta) * signedSquare(before_mps));
}

/// Normal force over 1/2 rho A V^2 at any angle of attack.
double normalCoefficient(double liftSlope, double stall_rad, double angle_rad) {
    const double wrapped = std::remainder(angle_rad, kTwoPi);
    const bool fromAft = std::abs(wrapped) > 0.5 * kPi;
    const double attack_rad = fromAft ? kPi - std::abs(wrapped) : std::abs(wrapped);
    const double stalled = smoothStep(stall_rad, stall_rad + kStallOver_rad, attack_rad);
    const double slope = (fromAft ? kFromAft : 1.0) * liftSlope;
    return std::sin(wrapped) * (slope + stalled * (kFlatPlate - slope));
}

}  // namespace

MmgRudderForce mmgRudderForce(const MmgParameters& model, const Hull& hull, const Steering& steering,
                              BodyPoint position, double angle_rad, const PropulsionUnit& unit,
                              const MmgPropeller& screw, bool inRace, const ShipMotion& m,
                              const MmgFlow& flow) {
    const MmgRudder& k = model.rudder;
    const double L = hull.lengthBp_m, rL = m.yawRate_radps * L;
    const double surge_mps = m.surge_mps - m.yawRate_radps * position.y_m;
    // 1 with the hull before the rudder, 0 with sternway.
    const double swing_mps = std::sqrt(flow.speed_mps * flow.speed_mps + 0.25 * rL * rL);
    const double headway = swing_mps == 0.0 ? 1.0 : smoothStep(-0.3, 0.3, surge_mps / swing_mps);
    const double lever = headway * k.lR + (1.0 - headway) * position.x_m / L;
    // The method's U beta is -v for small angles; beyond its range -v it is.
    const double drift_mps =
        flow.published * flow.speed_mps * flow.drift_rad - (1.0 - flow.published) * m.sway_mps;
    const double across_mps = drift_mps - lever * rL;
    const bool fromOutboard = position.y_m > 0.0 ? across_mps < 0.0 : across_mps >= 0.0;
    const double straightening = headway * (fromOutboard ? k.gammaPort : k.gammaStarboard) + (1.0 - headway);

    MmgRudderForce f;
    f.u_mps = inflowAlong_mps(k, unit, screw, inRace, hull.waterDensity_kgpm3);
    f.v_mps = straightening * across_mps;
    const double speed2 = f.u_mps * f.u_mps + f.v_mps * f.v_mps;
    if (speed2 == 0.0) return f;
    f.normal_N =
        0.5 * hull.waterDensity_kgpm3 * steering.areaEach_m2 * speed2 *
        normalCoefficient(k.liftSlope, steering.stallAngle_rad, angle_rad - std::atan2(f.v_mps, f.u_mps));
    const double hullTakesPart = smoothStep(-0.5, 0.5, f.u_mps / std::sqrt(speed2));
    const double aH = hullTakesPart * k.aH, tR = hullTakesPart * k.tR;
    const double lift_N = f.normal_N * std::cos(angle_rad);
    const double depth_m = hull.draught_m - 0.5 * k.height_m;  // the heel of the rudder is at the keel
    f.load.surge_N = -(1.0 - tR) * f.normal_N * std::sin(angle_rad);
    f.load.sway_N = -(1.0 + aH) * lift_N;
    f.load.roll_Nm = -depth_m * f.load.sway_N;
    f.load.yaw_Nm = -(position.x_m + aH * k.xH * L) * lift_N - position.y_m * f.load.surge_N;
    return f;
}

}  // namespace sagara::core
