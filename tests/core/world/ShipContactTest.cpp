#include <gtest/gtest.h>

#include <cmath>

#include "FreeBody.h"
#include "SmallAreas.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::FreeBody;

/// The other ship as this one sees her.
ShipObstacle seen(const FreeBody& other, std::int32_t index = -1) {
    return {other.hull.outline,
            other.hull.halfSize,
            other.motion.position(),
            other.motion.heading_rad,
            other.velocity(),
            other.mass_kg,
            index};
}
Obstacles only(const ShipObstacle& ship) {
    Obstacles found;
    found.ships.add(ship);
    return found;
}
struct Force {
    NorthEast force_N;
    double moment_Nm;  ///< about the origin of frame N
};
Force forceOn(const FreeBody& body, const FreeBody& other) {
    const Load load = contactLoad(only(seen(other)), body.hull, body.motion, {});
    const NorthEast force_N = body.frame().vector({load.surge_N, load.sway_N});
    return {force_N, load.yaw_Nm + cross(body.motion.position(), force_N)};
}
/// Both for a tick, each against the other as she was.
void tick(FreeBody& a, FreeBody& b) {
    const ShipObstacle seenA = seen(a), seenB = seen(b);
    a.tick(only(seenB));
    b.tick(only(seenA));
}

TEST(ShipContact, ApartThereIsNoLoad) {
    FreeBody a(54.0, 8.6, 400e3), b(54.0, 8.6, 400e3);
    b.motion.east_m = 8.7;
    const Force force = forceOn(a, b);
    EXPECT_EQ(force.force_N, NorthEast{});
    EXPECT_FALSE(findTouches(only(seen(b)), a.hull, a.motion, {}).back().touching);
}

struct Meeting {
    ShipMotion a, b;
};
class ShipsThatMeet : public ::testing::TestWithParam<Meeting> {};

TEST_P(ShipsThatMeet, PushEachOtherEquallyHard) {
    for (const double otherMass_kg : {400e3, 5e6, 3e4}) {
        FreeBody a(54.0, 8.6, 400e3), b(54.0, 8.6, otherMass_kg);
        a.motion = GetParam().a;
        b.motion = GetParam().b;
        const Force onA = forceOn(a, b), onB = forceOn(b, a);
        const double size_N = length(onA.force_N);
        ASSERT_GT(size_N, 0.0);
        EXPECT_NEAR(onA.force_N.north_m, -onB.force_N.north_m, 1e-6 * size_N);
        EXPECT_NEAR(onA.force_N.east_m, -onB.force_N.east_m, 1e-6 * size_N);
        // The two points of a contact lie apart by the overlap, and friction acts at both.
        EXPECT_NEAR(onA.moment_Nm, -onB.moment_Nm, 1.0 * size_N);
    }
}

TEST_P(ShipsThatMeet, SeparateWithLessEnergyAndTheSameMomentum) {
    FreeBody a(54.0, 8.6, 400e3), b(54.0, 8.6, 400e3);
    a.motion = GetParam().a;
    b.motion = GetParam().b;
    // Begin apart: back them off along their tracks.
    const NorthEast back = 10.0 * (a.velocity() - b.velocity());
    a.motion.north_m -= back.north_m;
    a.motion.east_m -= back.east_m;
    const double before_J = a.energy_J() + b.energy_J();
    const NorthEast before = a.velocity() + b.velocity();
    const double closing_mps = length(a.velocity() - b.velocity());
    for (int i = 0; i < 20 * kTicksPerSecond; ++i) {
        tick(a, b);
        ASSERT_LT(a.energy_J() + b.energy_J(), before_J * (1.0 + 1e-9));
    }
    EXPECT_LT(a.energy_J() + b.energy_J(), 0.98 * before_J);
    // Each sees the other as she was a tick ago and without her turning: part of what is exchanged.
    EXPECT_LT(length(a.velocity() + b.velocity() - before), 0.3 * closing_mps);
}
INSTANTIATE_TEST_SUITE_P(
    InManyWays, ShipsThatMeet,
    ::testing::Values(
        Meeting{{.surge_mps = 1.0}, {.north_m = 53.9, .heading_rad = kPi, .surge_mps = 1.0}},  // stem to stem
        Meeting{{.surge_mps = 1.0}, {.north_m = 31.2, .heading_rad = kPi / 2}},  // stem into a side
        Meeting{{.sway_mps = 0.5}, {.east_m = 8.5}},                             // flat alongside
        Meeting{{.surge_mps = 2.0, .sway_mps = 0.2},
                {.north_m = 5.0, .east_m = 8.5, .surge_mps = 1.0}},  // overtaking
        Meeting{{.surge_mps = 1.0},
                {.north_m = 22.0, .east_m = 22.0, .heading_rad = -kPi / 2 - 0.5, .surge_mps = 1.0}}));

TEST(ShipContact, TouchSaysWhoItWasAndTheEnergyOfTheTwoMasses) {
    FreeBody a(54.0, 8.6, 400e3), b(54.0, 8.6, 100e3);
    a.motion.surge_mps = 2.0;
    b.motion = {.north_m = 31.2, .east_m = 6.0, .heading_rad = kPi / 2};  // her flat side, across my stem
    const Touch touch =
        findTouches(only(seen(b, 7)), a.hull, a.motion, {})[static_cast<std::size_t>(ContactKind::Ship)];
    ASSERT_TRUE(touch.touching);
    EXPECT_EQ(touch.other, 7);
    EXPECT_NEAR(touch.approach_mps, 2.0, 0.01);
    // reduced mass 400 * 100 / 500 t
    EXPECT_NEAR(touch.energy_J, 0.5 * 80e3 * 4.0, 0.02 * touch.energy_J);
}

TEST(ShipContact, SpeedIsRelativeToTheOther) {
    FreeBody a(54.0, 8.6, 400e3), b(54.0, 8.6, 400e3);
    a.motion.surge_mps = 5.0;
    b.motion = {.north_m = 53.9, .surge_mps = 4.5};  // her transom ahead of my stem
    const Touch touch =
        findTouches(only(seen(b)), a.hull, a.motion, {})[static_cast<std::size_t>(ContactKind::Ship)];
    ASSERT_TRUE(touch.touching);
    EXPECT_NEAR(touch.approach_mps, 0.5, 0.01);
}

TEST(ShipContact, MoreShipsThanCanBeHeldDoNoHarm) {
    FreeBody a(54.0, 8.6, 400e3), b(10.0, 3.0, 2e4);
    Obstacles found;
    for (int i = 0; i < 20; ++i) {
        b.motion = {.north_m = -20.0 + 2.0 * i, .east_m = 5.7, .heading_rad = 0.0};
        found.ships.add(seen(b, i));
    }
    EXPECT_EQ(found.ships.count, 8u);
    for (int i = 0; i < 10 * kTicksPerSecond; ++i) a.tick(found);
    EXPECT_TRUE(std::isfinite(a.energy_J()));
    EXPECT_LT(length(a.velocity()), 1.0);
}

}  // namespace
}  // namespace sagara::core
