#include <gtest/gtest.h>

#include <cmath>

#include "TestShip.h"
#include "core/base/Units.h"
#include "core/world/Anchor.h"
#include "core/world/Catenary.h"

namespace sagara::core {
namespace {

constexpr double kWetSteel = 1.0 - 1025.0 / 7850.0;

/// An anchor dug in at the origin, its hawse towed north over the ground. Depth: a twelfth of the cable.
struct Towed {
    explicit Towed(const AnchorGear& anchorGear, double scope)
        : gear(anchorGear), ground{anchorGear.cableLength_m / 12.0, 1.0} {
        anchor.status = AnchorStatus::Held;
        anchor.onBottom = true;
        anchor.cableOut_m = scope * height_m();
        anchor.set = 1.0;
    }
    AnchorGear gear;
    AnchorGround ground;
    AnchorState anchor;
    double hawse_m = 0.0;  ///< north of the origin
    bool parted = false;

    double height_m() const { return ground.depth_m + gear.hawseHeight_m; }
    /// A hawse at the bow of a ship that heads south.
    ShipMotion ship() const {
        return {.north_m = hawse_m + gear.hawse.x_m, .east_m = gear.hawse.y_m, .heading_rad = kPi};
    }
    void tick(double speed_mps) {
        hawse_m += speed_mps * kTick_s;
        parted = parted || workAnchor(gear, anchor, ground, ship(), kTick_s);
    }
    double reach_m() const {
        return std::sqrt(anchor.cableOut_m * anchor.cableOut_m - height_m() * height_m());
    }
    double stiffness_N() const {
        return 5.6e10 * 2.0 * gear.cableMass_kgpm / (7850.0 * 3.55);
    }  // studlink, ISO 1704
    double flatHolding_N() const { return gear.holdingFactor * gear.anchorMass_kg * kGravity_mps2; }
};

const AnchorGear kPatrol = test::shippedVessel("patrol51").groundTackle.anchors[0];
const AnchorGear kTanker = test::shippedVessel("esso-osaka").groundTackle.anchors[0];

TEST(AnchorHolding, IsTheWeightTimesItsFactorOnceDugIn) {
    const AnchorGround good{18.0, 1.0}, soft{18.0, 0.5};
    AnchorState dugIn, fresh;
    dugIn.set = 1.0;
    const double full_N = kPatrol.holdingFactor * kPatrol.anchorMass_kg * kGravity_mps2;
    EXPECT_DOUBLE_EQ(holdingPower_N(kPatrol, dugIn, good, 0.0, 0.0), full_N);
    EXPECT_DOUBLE_EQ(holdingPower_N(kPatrol, dugIn, soft, 0.0, 0.0), 0.5 * full_N);
    EXPECT_NEAR(holdingPower_N(kPatrol, fresh, good, 0.0, 0.0), full_N / 3.0, 0.02 * full_N);  // "a third"
    dugIn.set = 0.5;
    EXPECT_NEAR(holdingPower_N(kPatrol, dugIn, good, 0.0, 0.0), (0.35 + 0.65 * 0.5) * full_N, 1e-6);
}

TEST(AnchorHolding, FallsByAFifteenthForEveryDegreeOfUplift) {
    const AnchorGround good{18.0, 1.0};
    AnchorState dugIn;
    dugIn.set = 1.0;
    const double full_N = holdingPower_N(kPatrol, dugIn, good, 0.0, 0.0);
    EXPECT_NEAR(holdingPower_N(kPatrol, dugIn, good, 0.0, 3.0 * kDegree_rad), 0.8 * full_N, 1e-6);
    EXPECT_NEAR(holdingPower_N(kPatrol, dugIn, good, 0.0, 80.0 * kDegree_rad), 0.2 * full_N,
                1e-6);  // never nothing
}

TEST(AnchorHolding, CableOnTheGroundAddsItsFriction) {
    const AnchorGround good{18.0, 1.0};
    const AnchorState anchor;
    const double more_N =
        holdingPower_N(kPatrol, anchor, good, 30.0, 0.0) - holdingPower_N(kPatrol, anchor, good, 0.0, 0.0);
    EXPECT_NEAR(more_N, kWetSteel * kPatrol.cableMass_kgpm * kGravity_mps2 * 30.0, 1e-6);
}

TEST(AnchorHolding, HalvesWhenDraggedFast) {
    AnchorState slow, fast;
    slow.dragSpeed_mps = 0.49;
    fast.dragSpeed_mps = 0.51;
    const AnchorGround good{18.0, 1.0};
    EXPECT_DOUBLE_EQ(holdingPower_N(kPatrol, fast, good, 0.0, 0.0),
                     0.5 * holdingPower_N(kPatrol, slow, good, 0.0, 0.0));
}

class AnchorGears : public ::testing::TestWithParam<const AnchorGear*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, AnchorGears, ::testing::Values(&kPatrol, &kTanker),
                         [](const auto& row) { return row.param == &kPatrol ? "Patrol51" : "EssoOsaka"; });

TEST_P(AnchorGears, ItDoesNotMoveBelowItsHoldingPower) {
    Towed t(*GetParam(), 7.0);
    t.hawse_m = 0.9 * t.reach_m();
    while (t.anchor.pull_N < 0.95 * t.flatHolding_N()) t.tick(0.1);
    const double pull_N = t.anchor.pull_N;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) t.tick(0.0);
    EXPECT_EQ(t.anchor.dragged_m, 0.0);
    EXPECT_EQ(t.anchor.dragSpeed_mps, 0.0);
    EXPECT_EQ(t.anchor.position, NorthEast{});
    EXPECT_EQ(t.anchor.pull_N, pull_N);
}

TEST_P(AnchorGears, ItMovesAboveAndStopsWhereThePullHasFallenToIt) {
    Towed t(*GetParam(), 7.0);
    t.hawse_m = 0.98 * t.reach_m();
    while (t.anchor.dragged_m < 10.0) t.tick(0.4);
    for (int i = 0; i < 120 * kTicksPerSecond; ++i) t.tick(0.0);
    EXPECT_GT(t.anchor.dragged_m, 0.0);
    EXPECT_NEAR(t.anchor.position.north_m, t.anchor.dragged_m, 1e-9);  // towards the ship
    const CableShape shape =
        cableShape(t.hawse_m - t.anchor.position.north_m, t.height_m(), t.anchor.cableOut_m,
                   kWetSteel * t.gear.cableMass_kgpm * kGravity_mps2, t.stiffness_N());
    const double holding_N = holdingPower_N(t.gear, t.anchor, t.ground, shape.lying_m, shape.uplift_rad);
    EXPECT_NEAR(t.anchor.pull_N, holding_N,
                1e-3 * holding_N);  // comes to it as a first-order lag of some seconds
    EXPECT_LT(t.anchor.dragSpeed_mps, 0.002);
}

TEST_P(AnchorGears, ItDigsInOverFourMetres) {
    Towed t(*GetParam(), 7.0);
    t.anchor.set = 0.0;
    t.hawse_m = 0.9 * t.reach_m();
    while (t.anchor.dragged_m < 1.0) t.tick(0.2);
    EXPECT_NEAR(t.anchor.set, 0.25, 0.01);
    while (t.anchor.dragged_m < 4.1) t.tick(0.2);
    EXPECT_EQ(t.anchor.set, 1.0);
}

TEST_P(AnchorGears, AStrongerTowIsNeededOnceItHasDugIn) {
    Towed fresh(*GetParam(), 7.0), dugIn(*GetParam(), 7.0);
    fresh.anchor.set = 0.0;
    fresh.hawse_m = dugIn.hawse_m = 0.9 * fresh.reach_m();
    while (fresh.anchor.dragged_m == 0.0) fresh.tick(0.2);
    while (dugIn.anchor.dragged_m == 0.0) dugIn.tick(0.2);
    EXPECT_LT(fresh.anchor.pull_N, 0.6 * dugIn.anchor.pull_N);
}

struct Tow {
    const AnchorGear* gear;
    double scope, speed_mps;
};
class DraggedAnchor : public ::testing::TestWithParam<Tow> {};

TEST_P(DraggedAnchor, FollowsTheShipAtHerSpeedUnderASteadyPull) {
    Towed t(*GetParam().gear, GetParam().scope);
    t.hawse_m = 0.98 * t.reach_m();
    while (t.anchor.dragged_m < 10.0) t.tick(GetParam().speed_mps);
    for (int i = 0; i < 60 * kTicksPerSecond; ++i) t.tick(GetParam().speed_mps);
    ASSERT_FALSE(t.parted);
    const double began_m = t.anchor.position.north_m, pull_N = t.anchor.pull_N;
    double least_N = pull_N, most_N = pull_N;
    for (int i = 0; i < 20 * kTicksPerSecond; ++i) {
        t.tick(GetParam().speed_mps);
        least_N = std::min(least_N, t.anchor.pull_N);
        most_N = std::max(most_N, t.anchor.pull_N);
    }
    EXPECT_NEAR((t.anchor.position.north_m - began_m) / 20.0, GetParam().speed_mps, 0.002);
    EXPECT_LT(most_N - least_N,
              1e-3 * pull_N);  // no saw teeth: neither numerical nor of the change at 0.5 m/s
    EXPECT_NEAR(t.anchor.dragSpeed_mps, GetParam().speed_mps, 0.01);
}

std::vector<Tow> tows() {
    std::vector<Tow> all;
    for (const AnchorGear* gear : {&kPatrol, &kTanker}) {
        for (const double scope : {3.0, 5.0, 7.0}) {
            for (const double speed_mps : {0.05, 0.3, 0.48, 0.52, 1.0, 3.0})
                all.push_back({gear, scope, speed_mps});
        }
    }
    return all;
}
INSTANTIATE_TEST_SUITE_P(AtEverySpeed, DraggedAnchor, ::testing::ValuesIn(tows()), [](const auto& row) {
    const Tow& tow = row.param;
    return std::string(tow.gear == &kPatrol ? "Patrol51" : "EssoOsaka") + "Scope" +
           std::to_string(int(tow.scope)) + "At" + std::to_string(int(std::lround(100.0 * tow.speed_mps))) +
           "cmps";
});

TEST_P(AnchorGears, PartsItsCableAtTheBreakingLoad) {
    Towed t(*GetParam(), 7.0);
    t.gear.holdingFactor = 1000.0;  // fouled
    t.hawse_m = 0.98 * t.reach_m();
    double most_N = 0.0;
    while (!t.parted) {
        t.tick(0.1);
        if (!t.parted) most_N = t.anchor.hawseTension_N;
        ASSERT_LT(t.hawse_m, 400.0);
    }
    EXPECT_LE(most_N, t.gear.breakingLoad_N);
    EXPECT_GT(most_N, 0.99 * t.gear.breakingLoad_N);  // 2 mm of stretch a tick
    EXPECT_EQ(t.anchor.status, AnchorStatus::CableParted);
    EXPECT_EQ(t.anchor.pull_N, 0.0);
    EXPECT_EQ(anchorLoad(t.gear, t.anchor, t.ship()).surge_N, 0.0);
    EXPECT_FALSE(workAnchor(t.gear, t.anchor, t.ground, t.ship(), kTick_s));  // once
}

TEST(AnchorLoad, PullsTheHawseTowardsTheAnchor) {
    AnchorState anchor;
    anchor.pull_N = 1000.0;
    anchor.position = {100.0, 100.0};
    ShipMotion east{.heading_rad = kPi / 2};  // hawse (23, -1.3) in B is at north 1.3, east 23
    const Load load = anchorLoad(kPatrol, anchor, east);
    const double north_m = 100.0 - 1.3, east_m = 100.0 - 23.0, far_m = std::hypot(north_m, east_m);
    EXPECT_NEAR(load.surge_N, 1000.0 * east_m / far_m, 1e-9);
    EXPECT_NEAR(load.sway_N, -1000.0 * north_m / far_m, 1e-9);
    EXPECT_NEAR(load.yaw_Nm, 23.0 * load.sway_N + 1.3 * load.surge_N, 1e-6);
}

TEST(AnchorAgain, ANewAttemptCountsItsDraggingAnew) {
    Towed t(kPatrol, 5.0);
    while (t.anchor.dragged_m < 20.0) t.tick(0.4);
    t.anchor.status = AnchorStatus::Heaving;
    t.anchor.stopAt_m = 10.0;
    while (t.anchor.onBottom) t.tick(t.hawse_m > t.anchor.position.north_m ? -0.4 : 0.0);
    t.anchor.status = AnchorStatus::Veering;
    t.anchor.stopAt_m = 100.0;
    while (!t.anchor.onBottom) t.tick(0.0);
    EXPECT_EQ(t.anchor.dragged_m, 0.0);
    EXPECT_EQ(t.anchor.set, 0.0);
}

}  // namespace
}  // namespace sagara::core
