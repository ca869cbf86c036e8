#include "core/world/UnderKeel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "SmallAreas.h"
#include "TestShip.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::TestShip;

/// Depth grows by `slope` for every metre north; `atOrigin_m` at the origin.
Area slope(double atOrigin_m, double slope) {
    Area area;
    const auto south = static_cast<float>(atOrigin_m - 1000.0 * slope),
               north = static_cast<float>(atOrigin_m + 1000.0 * slope);
    area.depths.push_back(Grid({-1000.0, -1000.0}, 2000.0, 2, 2, {south, south, north, north}));
    return area;
}

class UnderTheKeel : public ::testing::Test {
protected:
    TestShip ship{"patrol51"};  // 51.5 m between perpendiculars, beam 8.6 m, draught 2.3 m
    double clearance_m(const Area& area, double tide_m = 0.0) const {
        return underKeel(area, ship.keel, ship.motion, tide_m).clearance_m;
    }
};

TEST_F(UnderTheKeel, OnAFlatBottomIsDepthPlusTideLessDraught) {
    EXPECT_NEAR(clearance_m(test::openWater(8.0)), 5.7, 1e-6);
    EXPECT_NEAR(clearance_m(test::openWater(8.0), 0.4), 6.1, 1e-6);
    EXPECT_NEAR(clearance_m(test::openWater(2.0)), -0.3, 1e-6);  // aground
}

TEST_F(UnderTheKeel, HeaveRollAndPitchTakeFromIt) {
    const Area flat = test::openWater(8.0);
    ship.motion.down_m = 0.3;
    EXPECT_NEAR(clearance_m(flat), 5.4, 1e-6);
    ship.motion.down_m = 0.0;
    ship.motion.pitch_rad = 0.02;  // bow up: the stern is 0.45 L from midship
    EXPECT_NEAR(clearance_m(flat), 5.7 - 0.45 * 51.5 * 0.02, 1e-6);
    EXPECT_LT(underKeel(flat, ship.keel, ship.motion, 0.0).point.x_m, 0.0);
    ship.motion.pitch_rad = -0.02;
    EXPECT_NEAR(clearance_m(flat), 5.7 - 0.45 * 51.5 * 0.02, 1e-6);
    EXPECT_GT(underKeel(flat, ship.keel, ship.motion, 0.0).point.x_m, 0.0);
    ship.motion.pitch_rad = 0.0;
    ship.motion.roll_rad = 0.1;  // starboard down: the bilge is 0.3 B off the middle
    EXPECT_NEAR(clearance_m(flat), 5.7 - 0.3 * 8.6 * 0.1, 1e-6);
    EXPECT_GT(underKeel(flat, ship.keel, ship.motion, 0.0).point.y_m, 0.0);
}

TEST_F(UnderTheKeel, OnASlopeTheShallowEndCounts) {
    const Area area = slope(8.0, 0.02);
    EXPECT_NEAR(clearance_m(area), 5.7 - 0.02 * 0.45 * 51.5, 1e-5);  // heads north: her stern
    EXPECT_LT(underKeel(area, ship.keel, ship.motion, 0.0).point.x_m, 0.0);
    ship.motion.heading_rad = kPi;
    EXPECT_NEAR(clearance_m(area), 5.7 - 0.02 * 0.45 * 51.5, 1e-5);
    EXPECT_GT(underKeel(area, ship.keel, ship.motion, 0.0).point.x_m, 0.0);
    ship.motion.heading_rad = kPi / 2;  // along the slope: the starboard bilge
    EXPECT_NEAR(clearance_m(area), 5.7 - 0.02 * 0.3 * 8.6, 1e-5);
    EXPECT_GT(underKeel(area, ship.keel, ship.motion, 0.0).point.y_m, 0.0);
}

TEST_F(UnderTheKeel, SquatCountsInShallowWaterOnly) {
    const double block = ship.vessel.hull.blockCoefficient();
    ship.motion.surge_mps = 10.0 * kKnot_mps;
    EXPECT_NEAR(clearance_m(test::openWater(2.5 * 2.3 + 0.01)), 1.5 * 2.3 + 0.01,
                1e-6);  // deep from 2.5 draughts on
    EXPECT_NEAR(clearance_m(test::openWater(1.4 * 2.3)), 0.4 * 2.3 - block * 1.0,
                1e-6);  // Barrass: Cb V^2 / 100
    const double half = clearance_m(test::openWater(1.95 * 2.3));
    EXPECT_NEAR(half, 0.95 * 2.3 - 0.5 * block, 1e-6);
    ship.motion.surge_mps *= -1.0;  // astern too
    EXPECT_NEAR(clearance_m(test::openWater(1.4 * 2.3)), 0.4 * 2.3 - block * 1.0, 1e-6);
    ship.motion.surge_mps = 0.0;
    EXPECT_NEAR(clearance_m(test::openWater(1.4 * 2.3)), 0.4 * 2.3, 1e-6);
}

TEST_F(UnderTheKeel, AfloatTheGroundDoesNothing) {
    ship.motion.surge_mps = 3.0;
    const Load load = groundLoad(test::openWater(2.31), ship.keel, ship.motion, 0.0, {});
    EXPECT_EQ(load.heave_N, 0.0);
    EXPECT_EQ(load.surge_N, 0.0);
}

TEST_F(UnderTheKeel, TheGroundPushesUpWithTheStiffnessOfTheWaterplane) {
    const Load load = groundLoad(test::openWater(2.2), ship.keel, ship.motion, 0.0, {});
    const double stiffness_Npm = 1014.0 * kGravity_mps2 * ship.vessel.hull.waterplaneArea_m2();
    EXPECT_NEAR(load.heave_N, -0.1 * stiffness_Npm, 1e-4 * stiffness_Npm);
    EXPECT_NEAR(load.roll_Nm, 0.0, 1.0);
    EXPECT_NEAR(load.pitch_Nm, 0.0, 1.0);
}

TEST_F(UnderTheKeel, OnASlopeTheGroundLiftsTheShallowEnd) {
    const Load stern = groundLoad(slope(2.5, 0.02), ship.keel, ship.motion, 0.0, {});
    EXPECT_LT(stern.heave_N, 0.0);
    EXPECT_LT(stern.pitch_Nm, 0.0);  // bow down
    ship.motion.heading_rad = kPi / 2;
    const Load starboard = groundLoad(slope(2.28, 0.02), ship.keel, ship.motion, 0.0, {});
    EXPECT_LT(starboard.roll_Nm, 0.0);  // starboard side up
}

/// Moves her for a time on the ground and whatever pushes.
void settle(TestShip& ship, const Area& area, double tide_m, const Load& push, double seconds,
            NorthEast current = {}) {
    ship.current = current;
    for (int i = 0; i < static_cast<int>(seconds * kTicksPerSecond); ++i) {
        ship.tick(
            [&](const ShipMotion& m) { return push + groundLoad(area, ship.keel, m, tide_m, current); });
    }
}

class ShipAground : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, ShipAground, ::testing::Values("patrol51", "esso-osaka"),
                         [](const auto& row) { return std::string(row.param).substr(0, 4); });

TEST_P(ShipAground, FallingTideLeavesHalfItsFallToTheGround) {
    // Ground and waterplane are springs of the same stiffness: each carries half.
    TestShip ship(GetParam());
    const Area area = test::openWater(ship.vessel.hull.draught_m);
    settle(ship, area, -0.4, {}, 200.0);
    EXPECT_NEAR(ship.motion.down_m, -0.2, 0.002);
    EXPECT_NEAR(underKeel(area, ship.keel, ship.motion, -0.4).clearance_m, -0.2, 0.002);
    EXPECT_NEAR(ship.motion.roll_rad, 0.0, 1e-3);
    EXPECT_NEAR(ship.motion.pitch_rad, 0.0, 1e-4);
}

TEST_P(ShipAground, FrictionHoldsHerAgainstLessThanHalfTheWeightOnTheGround) {
    TestShip ship(GetParam());
    const Area area = test::openWater(ship.vessel.hull.draught_m);
    settle(ship, area, -0.4, {}, 200.0);
    const double onGround_N = 0.2 * ship.dynamics.heaveStiffness_Npm();
    const NorthEast before = ship.motion.position();
    const double push_N = 0.1 * onGround_N;  // of the 0.5 she is held with
    settle(ship, area, -0.4, {.surge_N = push_N}, 100.0);
    // Friction grows with the speed to its full at a few cm/s: she creeps at 0.05 m/s F / (mu N - F).
    EXPECT_NEAR(ship.motion.surge_mps, 0.05 * 0.1 / 0.4, 0.002);
    EXPECT_LT(distance(before, ship.motion.position()), 1.4);
    settle(ship, area, -0.4, {.surge_N = 0.7 * onGround_N}, 30.0);
    EXPECT_GT(ship.motion.surge_mps, 0.2);  // more than friction takes
}

TEST_P(ShipAground, ARisingTideFloatsHerOff) {
    TestShip ship(GetParam());
    const Area area = test::openWater(ship.vessel.hull.draught_m);
    settle(ship, area, -0.4, {}, 200.0);
    const double push_N = 0.02 * ship.dynamics.heaveStiffness_Npm() * 0.2;
    for (double tide_m = -0.4; tide_m < 0.1; tide_m += 0.01)
        settle(ship, area, tide_m, {.surge_N = push_N}, 5.0);
    settle(ship, area, 0.1, {.surge_N = push_N}, 60.0);
    EXPECT_GT(underKeel(area, ship.keel, ship.motion, 0.1).clearance_m, 0.0);  // 0.1 m less the squat
    EXPECT_NEAR(ship.motion.down_m, 0.0, 0.005);
    EXPECT_GT(ship.motion.surge_mps, 0.01);  // nothing holds her
}

TEST_P(ShipAground, RunningOnAShoalSheIsStoppedAndStays) {
    TestShip ship(GetParam());
    const Area shoal = slope(ship.vessel.hull.draught_m + 2.0, -0.02);  // rises one in fifty to the north
    ship.motion.surge_mps = 3.0;
    double fastest_mps = 0.0;
    for (int i = 0; i < 300 * kTicksPerSecond; ++i) {
        settle(ship, shoal, 0.0, {}, kTick_s);
        fastest_mps = std::max(fastest_mps, std::hypot(ship.motion.surge_mps, ship.motion.sway_mps));
    }
    EXPECT_LE(fastest_mps, 3.0);
    EXPECT_LT(length(ship.overGround_mps()), 0.05);
    EXPECT_LT(underKeel(shoal, ship.keel, ship.motion, 0.0).clearance_m, 0.0);
    EXPECT_GT(ship.motion.pitch_rad, 0.0);  // her bow has ridden up
}

TEST_P(ShipAground, ACurrentDoesNotCarryHerAway) {
    TestShip ship(GetParam());
    const Area area = test::openWater(ship.vessel.hull.draught_m);
    settle(ship, area, -0.4, {}, 100.0);
    settle(ship, area, -0.4, {}, 200.0, {0.3, 0.2});
    EXPECT_LT(length(ship.overGround_mps()), 0.03);  // she creeps, as above
}

}  // namespace
}  // namespace sagara::core
