#include "core/world/Hostile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/base/SimTime.h"

namespace sagara::core {
namespace {

constexpr double kFastest_mps = 12.9;

/// A fast craft that loiters at the origin, and an own ship that goes straight.
struct Encounter {
    Encounter(NorthEast ownAt, double ownHeading_rad, double ownSpeed_mps)
        : own(ownAt), heading_rad(ownHeading_rad), speed_mps(ownSpeed_mps) {
        layout.type = TargetType::FastCraft;
        layout.behaviour = TargetBehaviour::Hostile;
        layout.length_m = 9.0;
        layout.route = {{{0.0, 0.0}, kFastest_mps}};
        craft = startOf(layout);
    }
    TargetLayout layout;
    TargetState craft;
    NorthEast own;
    double heading_rad, speed_mps;
    double time_s = 0.0;

    double range_m() const { return distance(craft.position, own); }
    void tick() {
        const TargetIntent intent = hostileIntent(layout, craft, own, heading_rad, speed_mps, kTick_s);
        moveTarget(layout, craft, intent, {}, kTick_s);
        own = own + kTick_s * speed_mps * unitVector(heading_rad);
        time_s += kTick_s;
    }
    /// Until she is in a phase; false when she is not within the time.
    bool until(HostilePhase phase, double atMost_s) {
        for (const double end_s = time_s + atMost_s; craft.phase != phase && time_s < end_s;) tick();
        return craft.phase == phase;
    }
};

TEST(Hostile, LoitersAboutHerPlaceWhileNobodyIsNear) {
    Encounter e({5000.0, 0.0}, 0.0, 0.0);
    for (int i = 0; i < 1800 * kTicksPerSecond; ++i) {
        e.tick();
        ASSERT_EQ(e.craft.phase, HostilePhase::Loiter);
        ASSERT_LT(length(e.craft.position), 250.0);
    }
    EXPECT_NEAR(length(e.craft.position), 150.0, 15.0);
    EXPECT_NEAR(e.craft.speed_mps, 0.25 * kFastest_mps, 0.1);
}

TEST(Hostile, NoticesAShipWithinAMileAndCloses) {
    Encounter e({2500.0, 0.0}, kPi, 5.0);  // comes down on her
    ASSERT_TRUE(e.until(HostilePhase::Close, 400.0));
    EXPECT_NEAR(e.range_m(), 1852.0, 1.0);
    const double before_m = e.range_m();
    for (int i = 0; i < 30 * kTicksPerSecond; ++i) e.tick();
    EXPECT_LT(e.range_m(), before_m - 250.0);
    ASSERT_TRUE(e.until(HostilePhase::Harass, 300.0));
    EXPECT_NEAR(e.range_m(), 400.0, 5.0);
}

TEST(Hostile, WithdrawsAfterFourMinutesRestsThreeAndComesAgain) {
    Encounter e({1000.0, 0.0}, 0.0, 0.0);
    ASSERT_TRUE(e.until(HostilePhase::Harass, 300.0));
    const double harassed_s = e.time_s;
    ASSERT_TRUE(e.until(HostilePhase::Withdraw, 300.0));
    EXPECT_NEAR(e.time_s - harassed_s, 240.0, 0.1);
    const double withdrew_s = e.time_s;
    for (int i = 0; i < 60 * kTicksPerSecond; ++i) e.tick();
    EXPECT_LT(length(e.craft.position), 700.0);  // homeward, 1000 m from the ship
    ASSERT_TRUE(e.until(HostilePhase::Loiter, 300.0));
    EXPECT_NEAR(e.time_s - withdrew_s, 180.0, 0.1);
    EXPECT_TRUE(e.until(HostilePhase::Close, 10.0));  // the ship is still there
}

TEST(Hostile, LetsAShipGoThatOutrunsHer) {
    Encounter e({0.0, 1000.0}, kPi / 2, 25.0);
    ASSERT_TRUE(e.until(HostilePhase::Close, 10.0));
    EXPECT_TRUE(e.until(HostilePhase::Loiter, 600.0));
    EXPECT_NEAR(e.range_m(), 2 * 1852.0, 30.0);
}

struct Straight {
    double speed_mps, from_rad, heading_rad;
};
class HarassedShip : public ::testing::TestWithParam<Straight> {};

TEST_P(HarassedShip, IsPressedButNotRammed) {
    const Straight& s = GetParam();
    Encounter e(1500.0 * unitVector(s.from_rad), s.heading_rad, s.speed_mps);
    double nearest_m = 1e9, farthest_m = 0.0, harassed_s = 0.0, fastest_mps = 0.0, across_s = 0.0;
    for (int i = 0; i < 900 * kTicksPerSecond; ++i) {
        e.tick();
        nearest_m = std::min(nearest_m, e.range_m());
        fastest_mps = std::max(fastest_mps, e.craft.speed_mps);
        if (e.craft.phase != HostilePhase::Harass) continue;
        harassed_s += kTick_s;
        farthest_m = std::max(farthest_m, e.range_m());
        const double ahead_rad = wrapPi(bearing_rad(e.own, e.craft.position) - e.heading_rad);
        if (std::abs(ahead_rad) < 0.5) across_s += kTick_s;
    }
    EXPECT_GT(nearest_m, 60.0);
    EXPECT_LE(fastest_mps, kFastest_mps + 1e-9);  // no faster than she can
    EXPECT_GT(harassed_s, 60.0);
    EXPECT_LT(nearest_m, 250.0);  // she does press
    EXPECT_GT(across_s, 1.0);     // across the bow too
}

std::vector<Straight> straights() {
    std::vector<Straight> all;
    for (const double speed_mps : {0.0, 5.0, 10.0}) {
        for (int from = 0; from < 4; ++from) {
            for (int heading = 0; heading < 8; ++heading) {
                if (speed_mps == 0.0 && heading % 4 != 0) continue;
                all.push_back({speed_mps, from * kPi / 2, heading * kPi / 4});
            }
        }
    }
    return all;
}
INSTANTIATE_TEST_SUITE_P(GoingStraight, HarassedShip, ::testing::ValuesIn(straights()), [](const auto& row) {
    const auto degrees = [](double angle_rad) {
        return std::to_string(std::lround(angle_rad / kDegree_rad));
    };
    return "At" + std::to_string(std::lround(row.param.speed_mps)) + "mpsFrom" + degrees(row.param.from_rad) +
           "Heading" + degrees(row.param.heading_rad);
});

TEST(Hostile, NothingAboutHerJumpsAsHerMindChanges) {
    Encounter e({1700.0, 300.0}, kPi, 6.0);
    for (int i = 0; i < 1500 * kTicksPerSecond; ++i) {
        const TargetState before = e.craft;
        e.tick();
        ASSERT_LE(std::abs(e.craft.speed_mps - before.speed_mps), kFastest_mps / 4.0 * kTick_s + 1e-9);
        ASSERT_LE(std::abs(e.craft.yawRate_radps), 0.35 + 1e-9);
        ASSERT_LE(std::abs(e.craft.yawRate_radps - before.yawRate_radps), 2.0 * 0.35 / 0.72 * kTick_s + 1e-9);
        ASSERT_LE(distance(e.craft.position, before.position), kFastest_mps * kTick_s + 1e-9);
    }
}

TEST(Hostile, TheSameEncounterTwiceIsTheSameToTheBit) {
    Encounter a({1200.0, 700.0}, 3.0, 7.0), b({1200.0, 700.0}, 3.0, 7.0);
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) {
        a.tick();
        b.tick();
        ASSERT_EQ(a.craft.position, b.craft.position);
        ASSERT_EQ(a.craft.heading_rad, b.craft.heading_rad);
        ASSERT_EQ(a.craft.phase, b.craft.phase);
    }
}

}  // namespace
}  // namespace sagara::core
