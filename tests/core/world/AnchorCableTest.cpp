#include <gtest/gtest.h>

#include <cmath>

#include "TestShip.h"
#include "core/base/Units.h"
#include "core/world/Anchor.h"

namespace sagara::core {
namespace {

/// Buoyancy takes 13 % of steel's weight.
constexpr double kWetSteel = 1.0 - 1025.0 / 7850.0;

/// The port anchor of a ship that stays where she is told, head north, in 18 m.
class AnchorCable : public ::testing::Test {
protected:
    const AnchorGear gear = test::shippedVessel("patrol51").groundTackle.anchors[0];
    const AnchorGround ground{18.0, 1.0};
    const double height_m = 18.0 + gear.hawseHeight_m;
    AnchorState anchor;
    ShipMotion ship;
    double time_s = 0.0;

    NorthEast hawse() const { return HeadingFrame(ship.position(), ship.heading_rad).point(gear.hawse); }
    bool tick() {
        time_s += kTick_s;
        return workAnchor(gear, anchor, ground, ship, kTick_s);
    }
    void letGo(double cable_m) {
        anchor.status = AnchorStatus::Running;
        anchor.stopAt_m = cable_m;
    }
    /// Works it until the brake is on.
    void untilHeld() {
        for (int i = 0; i < 100'000 && anchor.status != AnchorStatus::Held; ++i) tick();
    }
    /// Cable speed over a second.
    double speed_mps() {
        const double before_m = anchor.cableOut_m;
        for (int i = 0; i < kTicksPerSecond; ++i) tick();
        return anchor.cableOut_m - before_m;
    }
};

TEST_F(AnchorCable, AnAnchorAtHomeDoesNothing) {
    for (int i = 0; i < 10; ++i) EXPECT_FALSE(tick());
    EXPECT_EQ(anchor.status, AnchorStatus::Home);
    EXPECT_EQ(anchor.cableOut_m, 0.0);
    EXPECT_EQ(anchorLoad(gear, anchor, ship).surge_N, 0.0);
}

TEST_F(AnchorCable, LetGoItFallsToTheGroundUnderTheHawse) {
    ship = {.north_m = 100.0, .east_m = -50.0, .heading_rad = 1.0};
    letGo(100.0);
    while (!anchor.onBottom) {
        EXPECT_EQ(anchor.pull_N, 0.0);
        // what hangs is carried by the hawse
        EXPECT_NEAR(
            anchor.hawseTension_N,
            kWetSteel * kGravity_mps2 *
                (anchor.cableOut_m > 0.0 ? gear.anchorMass_kg + gear.cableMass_kgpm * anchor.cableOut_m
                                         : 0.0),
            1e-6);
        tick();
        ASSERT_LT(time_s, 10.0);
    }
    EXPECT_NEAR(time_s, height_m / 4.0, kTick_s);  // falls at 4 m/s
    EXPECT_NEAR(distance(anchor.position, hawse()), 0.0, 1e-12);
    EXPECT_EQ(anchor.set, 0.0);
}

TEST_F(AnchorCable, TheBrakeGoesOnAtTheOrderedLength) {
    letGo(55.0);
    untilHeld();
    EXPECT_GE(anchor.cableOut_m, 55.0);
    EXPECT_LE(anchor.cableOut_m, 55.0 + 4.0 * kTick_s);  // what runs out in one tick
    const double out_m = anchor.cableOut_m;
    EXPECT_EQ(speed_mps(), 0.0);
    EXPECT_EQ(anchor.cableOut_m, out_m);
    EXPECT_EQ(anchor.pull_N, 0.0);  // it lies in a heap under her
}

TEST_F(AnchorCable, AllTheCableIsTheMostThatRunsOut) {
    letGo(1e6);
    untilHeld();
    EXPECT_DOUBLE_EQ(anchor.cableOut_m, gear.cableLength_m);
}

TEST_F(AnchorCable, RunningCableFollowsAShipThatMovesFasterThanItFalls) {
    letGo(120.0);
    ship.surge_mps = -3.0;
    while (anchor.status == AnchorStatus::Running) {
        if (anchor.onBottom) {
            ASSERT_GE(anchor.cableOut_m, distance(anchor.position, hawse()) + height_m - 1e-9) << time_s;
            ASSERT_LT(anchor.pull_N, 1e-6) << time_s;
        }
        ship.north_m += ship.surge_mps * kTick_s;
        tick();
        ASSERT_LT(time_s, 60.0);
    }
    EXPECT_LT(anchor.pull_N, 10.0);  // the brake went on in this tick
    EXPECT_EQ(anchor.dragged_m, 0.0);
    EXPECT_LE(anchor.cableOut_m, 120.0 + 3.0 * kTick_s);
}

TEST_F(AnchorCable, BrakedAboveTheGroundItHangsAndCanBeVeeredToIt) {
    letGo(10.0);
    untilHeld();
    EXPECT_FALSE(anchor.onBottom);
    EXPECT_EQ(anchor.pull_N, 0.0);
    ship.north_m += 500.0;  // carried along
    tick();
    EXPECT_FALSE(anchor.onBottom);
    anchor.status = AnchorStatus::Veering;
    anchor.stopAt_m = 50.0;
    untilHeld();
    EXPECT_TRUE(anchor.onBottom);
    EXPECT_NEAR(distance(anchor.position, hawse()), 0.0, 1e-12);
}

TEST_F(AnchorCable, VeersAtAWalkAndHeavesAtTheWindlassSpeed) {
    letGo(55.0);
    untilHeld();
    anchor.status = AnchorStatus::Veering;
    anchor.stopAt_m = 80.0;
    EXPECT_NEAR(speed_mps(), 0.8, 1e-9);
    untilHeld();
    EXPECT_NEAR(anchor.cableOut_m, 80.0, 0.8 * kTick_s);
    anchor.status = AnchorStatus::Heaving;
    anchor.stopAt_m = 60.0;
    EXPECT_NEAR(speed_mps(), -gear.heaveSpeed_mps, 1e-9);
    untilHeld();
    EXPECT_NEAR(anchor.cableOut_m, 60.0, gear.heaveSpeed_mps * kTick_s);
}

TEST_F(AnchorCable, UpAndDownTheWindlassBreaksItOut) {
    letGo(55.0);
    untilHeld();
    ship.north_m += 5.0;
    anchor.status = AnchorStatus::Heaving;
    anchor.stopAt_m = 0.0;
    while (anchor.onBottom) {
        EXPECT_GE(anchor.cableOut_m, height_m);
        tick();
        ASSERT_LT(time_s, 1000.0);
    }
    EXPECT_NEAR(anchor.cableOut_m, height_m + 1.0, 0.01);
    EXPECT_EQ(anchor.pull_N, 0.0);
    ship.north_m += 200.0;  // comes with her
    for (int i = 0; i < kTicksPerSecond; ++i) {
        tick();
        EXPECT_FALSE(anchor.onBottom);
        EXPECT_EQ(anchorLoad(gear, anchor, ship).surge_N, 0.0);
    }
}

TEST_F(AnchorCable, HoveRightInItIsHomeAsIfNothingHadBeen) {
    letGo(55.0);
    untilHeld();
    ship.north_m += 3.0;
    anchor.status = AnchorStatus::Heaving;
    anchor.stopAt_m = 0.0;
    const double cable_m = anchor.cableOut_m, began_s = time_s;
    while (anchor.status != AnchorStatus::Home) {
        tick();
        ASSERT_LT(time_s, 1000.0);
    }
    EXPECT_NEAR(time_s - began_s, cable_m / gear.heaveSpeed_mps, 2 * kTick_s);
    EXPECT_EQ(anchor.cableOut_m, 0.0);
    EXPECT_EQ(anchor.hawseTension_N, 0.0);
    EXPECT_EQ(anchor.dragged_m, 0.0);
    EXPECT_FALSE(anchor.onBottom);
}

TEST_F(AnchorCable, ACableTooShortForTheDepthLiftsTheAnchor) {
    letGo(height_m + 5.0);
    untilHeld();
    ASSERT_TRUE(anchor.onBottom);
    const AnchorGround deep{30.0, 1.0};
    ship.north_m += 100.0;  // she has drifted off the bank, the anchor with her
    workAnchor(gear, anchor, deep, ship, kTick_s);
    EXPECT_FALSE(anchor.onBottom);
    workAnchor(gear, anchor, ground, ship, kTick_s);  // the next bank
    EXPECT_TRUE(anchor.onBottom);
    EXPECT_NEAR(distance(anchor.position, hawse()), 0.0, 1e-12);
    EXPECT_EQ(anchor.pull_N, 0.0);
}

TEST(AnchorStatusNames, AreThoseOfTheDocuments) {
    EXPECT_STREQ(anchorStatusName(AnchorStatus::Home), "home");
    EXPECT_STREQ(anchorStatusName(AnchorStatus::Running), "running");
    EXPECT_STREQ(anchorStatusName(AnchorStatus::Held), "held");
    EXPECT_STREQ(anchorStatusName(AnchorStatus::Veering), "veering");
    EXPECT_STREQ(anchorStatusName(AnchorStatus::Heaving), "heaving");
    EXPECT_STREQ(anchorStatusName(AnchorStatus::CableParted), "cableParted");
}

}  // namespace
}  // namespace sagara::core
