#include "core/motion/Planing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"
#include "tests/support/hulls/Tables.h"

namespace sagara::core {
namespace {

Vessel rib() { return loadVessel("rib8.json", test::readAsset("vessels/rib8.json")).value(); }

/// The 80-foot craft of Savitsky and Brown (1976) at 13.07 m/s, as computed by an open implementation of the
/// same formulas (OpenPlaning, example of its README): 7.315 m over the chines, deadrise 15 deg, running at
/// 2.880351 deg with a mean wetted length of 3.19842 beams; vertical force 780367 N, moment about the centre
/// of gravity, 10.668 m from the transom, 301094.5 Nm, water 1025.87 kg/m3, g 9.8066.
TEST(Planing, IsThatOfSavitsky) {
    constexpr double kSpeed_mps = 13.07, kBeam_m = 7.315, kTrim_deg = 2.880351, kWetted = 3.19842;
    const double speed = kSpeed_mps / std::sqrt(9.8066 * kBeam_m);
    EXPECT_NEAR(speed, 1.543154, 1e-6);
    const double lift = wedgeLift(planingLift(speed, kTrim_deg, kWetted).flat(), 15.0 * kDegree_rad);
    const double force_N = lift * 0.5 * 1025.87 * kSpeed_mps * kSpeed_mps * kBeam_m * kBeam_m;
    EXPECT_NEAR(force_N, 780367.3, 1e-5 * 780367.3);
    const double lever_m = kBeam_m * pressureCentre(speed, kWetted) - 10.668;
    EXPECT_NEAR(lever_m * force_N / std::cos(kTrim_deg * kDegree_rad), 301094.5, 1e-3 * 301094.5);
    EXPECT_NEAR(flatLift(lift, 15.0 * kDegree_rad), planingLift(speed, kTrim_deg, kWetted).flat(), 1e-9);
}

TEST(Planing, FloatsRisesOverAHumpAndRunsFlatter) {
    const Vessel vessel = rib();
    const Planing planing(*vessel.planing, vessel.hull);
    EXPECT_EQ(planing.at(0.0).down_m, 0.0);
    EXPECT_EQ(planing.at(-5.0).pitch_rad, 0.0);
    EXPECT_EQ(planing.at(2.5).planing, 0.0);
    const RunningAttitude hump = planing.at(8.0), fast = planing.at(17.0);
    EXPECT_GT(hump.pitch_rad, 4.0 * kDegree_rad);
    EXPECT_LT(hump.pitch_rad, 8.0 * kDegree_rad);
    EXPECT_GT(fast.pitch_rad, 2.0 * kDegree_rad);
    EXPECT_LT(fast.pitch_rad, 4.0 * kDegree_rad);
    EXPECT_LT(fast.down_m, hump.down_m);
    EXPECT_GT(fast.down_m, -vessel.hull.draught_m);
    EXPECT_GT(fast.planing, 0.85);
    for (double U = 0.0; U < 25.0; U += 0.1) {
        const RunningAttitude a = planing.at(U), b = planing.at(U + 0.1);
        EXPECT_LT(std::abs(b.pitch_rad - a.pitch_rad), 0.5 * kDegree_rad) << U;
        EXPECT_LT(std::abs(b.down_m - a.down_m), 0.02) << U;
    }
}

/// Driven at a speed straight ahead on the tables of her hull, until she is steady.
ShipMotion steady(const ShipDynamics& ship, const Hull& hull, double surge_mps) {
    MovingShip m;
    Load drive;
    for (int i = 0; i < 3000; ++i) {
        m.motion.surge_mps = surge_mps;
        drive.surge_N -= 0.1 * hull.mass_kg() * ship.derivative(m, {}, drive, {}, {}).motion.surge_mps;
        m = rk4Step(m, 0.02, [&](const MovingShip& x) { return ship.derivative(x, {}, drive, {}, {}); });
    }
    return m.motion;
}

TEST(Planing, OnTheTablesSheComesToHerAttitude) {
    const Vessel vessel = rib();
    const Planing planing(*vessel.planing, vessel.hull);
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    const ShipMotion still = steady(ship, vessel.hull, 0.0);
    for (const double U : {4.0, 8.0, 17.0}) {
        const ShipMotion m = steady(ship, vessel.hull, U);
        const RunningAttitude a = planing.at(U);
        EXPECT_NEAR(m.pitch_rad - still.pitch_rad, a.pitch_rad, 0.02 * a.pitch_rad + 1e-4) << U;
        EXPECT_NEAR(m.down_m - still.down_m, a.down_m, 0.02 * std::abs(a.down_m) + 1e-3) << U;
    }
}

/// Heeling moment of the side force on the hull in a slip to port of 4 degrees, as in a turn to starboard.
double heel_Nm(const Vessel& vessel, double surge_mps) {
    const ShipDynamics ship(vessel);
    ShipMotion m;
    m.surge_mps = surge_mps;
    m.sway_mps = -0.07 * surge_mps;
    return ship.derivative(m, {}, {}, {}).rollRate_radps;
}

TEST(Planing, InATurnSheLeansOutwardAfloatAndInwardOnThePlane) {
    Vessel vessel = rib();
    EXPECT_LT(heel_Nm(vessel, 2.5), 0.0);
    EXPECT_GT(heel_Nm(vessel, 17.0), 0.0);
    vessel.planing.reset();
    EXPECT_LT(heel_Nm(vessel, 17.0), 0.0);
}

TEST(Planing, ABottomThatDoesNotFitTheHullIsRefused) {
    std::string text = test::readAsset("vessels/rib8.json");
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace("\"chineBeam_m\": 2.2", "\"chineBeam_m\": 3.2");
    replace("\"gravityFromTransom_m\": 2.9", "\"gravityFromTransom_m\": 5.9");
    const auto loaded = loadVessel("rib8.json", text);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(
        loaded.error().text(),
        "rib8.json: planing.chineBeam_m is 3.2, expected at most the beam, 2.8 m\n"
        "rib8.json: planing.gravityFromTransom_m is 5.9, expected 1.4 to 4.2 m, 0.2 to 0.6 of lengthBp_m");
}

}  // namespace
}  // namespace sagara::core
