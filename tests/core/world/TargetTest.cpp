#include "core/world/Target.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/base/SimTime.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

TargetLayout craft(TargetType type, double length_m, double speed_mps, const std::vector<NorthEast>& points,
                   TargetBehaviour behaviour = TargetBehaviour::Route) {
    TargetLayout layout;
    layout.type = type;
    layout.behaviour = behaviour;
    layout.length_m = length_m;
    layout.beam_m = length_m / 6.0;
    layout.draught_m = length_m / 20.0;
    for (const NorthEast p : points) layout.route.push_back({p, speed_mps});
    return layout;
}

void follow(const TargetLayout& layout, TargetState& state, NorthEast current = {}) {
    moveTarget(layout, state, followRoute(layout, state), current, kTick_s);
}

struct Kind {
    const char* name;
    TargetType type;
    double length_m, speed_mps;
};
const Kind kKinds[] = {{"Fishing", TargetType::Fishing, 12.0, 2.0},
                       {"Coaster", TargetType::Coaster, 78.0, 4.0},
                       {"Container", TargetType::Container, 190.0, 7.7},
                       {"FastCraft", TargetType::FastCraft, 9.0, 12.9}};
class TargetOfKind : public ::testing::TestWithParam<Kind> {
protected:
    const Kind kind = GetParam();
    bool fast() const { return kind.type == TargetType::FastCraft; }
    double radius_m() const { return (fast() ? 1.5 : 2.5) * kind.length_m; }
};
INSTANTIATE_TEST_SUITE_P(Shipped, TargetOfKind, ::testing::ValuesIn(kKinds),
                         [](const auto& row) { return row.param.name; });

TEST_P(TargetOfKind, BeginsOnHerFirstLegAtItsSpeed) {
    const TargetLayout layout =
        craft(kind.type, kind.length_m, kind.speed_mps, {{0.0, 0.0}, {1000.0, 1000.0}});
    const TargetState state = startOf(layout);
    EXPECT_FALSE(state.present);
    EXPECT_EQ(state.position, (NorthEast{0.0, 0.0}));
    EXPECT_DOUBLE_EQ(state.heading_rad, kPi / 4);
    EXPECT_EQ(state.speed_mps, kind.speed_mps);
    EXPECT_EQ(state.leg, 1u);
}

TEST_P(TargetOfKind, NothingAboutHerJumps) {
    // a square with corners she has to turn hard for, and orders that come out of the blue
    TargetLayout layout =
        craft(kind.type, kind.length_m, kind.speed_mps,
              {{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 2000.0}, {0.0, 2000.0}}, TargetBehaviour::Circuit);
    TargetState state = startOf(layout);
    // Most her lags allow from one tick to the next: differences over time constants.
    const double speedStep_mps = 2.0 * kind.speed_mps / (fast() ? 4.0 : 5.0 + 0.4 * kind.length_m) * kTick_s;
    const double most_radps = std::min(1.5 * kind.speed_mps / radius_m(), 0.35);
    const double turnStep_radps = 2.0 * most_radps / std::max(0.5, 0.08 * kind.length_m) * kTick_s;
    for (int i = 0; i < 1200 * kTicksPerSecond; ++i) {
        const TargetState before = state;
        if (i == 300 * kTicksPerSecond) state.orderedSpeed_mps = 1.5 * kind.speed_mps;
        if (i == 600 * kTicksPerSecond) state.orderedSpeed_mps = -1.0;
        if (i == 900 * kTicksPerSecond) state.stopped = true;
        follow(layout, state);
        ASSERT_LE(std::abs(state.speed_mps - before.speed_mps), speedStep_mps) << i;
        ASSERT_LE(std::abs(state.yawRate_radps - before.yawRate_radps), turnStep_radps) << i;
        ASSERT_LE(std::abs(state.yawRate_radps), most_radps + 1e-9) << i;
        ASSERT_LE(std::abs(wrapPi(state.heading_rad - before.heading_rad)), most_radps * kTick_s + 1e-9) << i;
        ASSERT_LE(distance(state.position, before.position), 1.6 * kind.speed_mps * kTick_s) << i;
        ASSERT_GE(state.speed_mps, 0.0) << i;
    }
}

TEST_P(TargetOfKind, TurnsInTheCircleOfHerKindAtAnySpeed) {
    const TargetLayout layout = craft(kind.type, kind.length_m, kind.speed_mps, {{0.0, 0.0}, {1000.0, 0.0}});
    for (const double factor : {0.3, 1.0}) {
        TargetState state = startOf(layout);
        state.speed_mps = factor * kind.speed_mps;
        double northmost_m = 0.0, southmost_m = 0.0;
        for (int i = 0; i < 40 * 60 * kTicksPerSecond; ++i) {
            const TargetIntent intent{state.heading_rad + kPi / 2,
                                      state.speed_mps};  // hard to starboard for ever
            moveTarget(layout, state, intent, {}, kTick_s);
            if (i < 20 * 60 * kTicksPerSecond) {
                northmost_m = southmost_m = state.position.north_m;
                continue;
            }
            northmost_m = std::max(northmost_m, state.position.north_m);
            southmost_m = std::min(southmost_m, state.position.north_m);
        }
        // wide of the tightest where the helm asks for less than the limit, 0.35 rad/s or 0.24 for a right
        // angle
        const double tightest_m = std::max(
            {radius_m(), state.speed_mps / 0.35, state.speed_mps / (0.15 * kPi / 2 * (fast() ? 4.0 : 1.0))});
        EXPECT_NEAR(0.5 * (northmost_m - southmost_m), tightest_m, 0.02 * tightest_m) << factor;
    }
}

TEST_P(TargetOfKind, ReachesEveryWaypointAndThenLiesStoppedAtTheLast) {
    const TargetLayout layout = craft(kind.type, kind.length_m, kind.speed_mps,
                                      {{0.0, 0.0}, {3000.0, 0.0}, {5000.0, 2500.0}, {4000.0, 5000.0}});
    TargetState state = startOf(layout);
    for (int i = 0; i < 3 * 3600 * kTicksPerSecond && state.leg < 4; ++i) follow(layout, state);
    EXPECT_EQ(state.leg, 4u);
    for (int i = 0; i < 1200 * kTicksPerSecond; ++i) follow(layout, state);
    EXPECT_LT(state.speed_mps, 0.001);
    EXPECT_LT(distance(state.position, layout.route.back().position), 100.0);
}

TEST_P(TargetOfKind, GoesRoundAndRoundItsCircuit) {
    const TargetLayout layout =
        craft(kind.type, kind.length_m, kind.speed_mps,
              {{0.0, 0.0}, {2500.0, 0.0}, {2500.0, 2500.0}, {0.0, 2500.0}}, TargetBehaviour::Circuit);
    TargetState state = startOf(layout);
    int rounds = 0;
    std::uint32_t leg = state.leg;
    for (int i = 0; i < 5 * 3600 * kTicksPerSecond && rounds < 3; ++i) {
        follow(layout, state);
        if (state.leg == 0 && leg == 3) ++rounds;
        leg = state.leg;
        ASSERT_LT(distance(state.position, {1250.0, 1250.0}), 2600.0);
    }
    EXPECT_EQ(rounds, 3);
}

TEST_P(TargetOfKind, DoesNotCircleForEverRoundAWaypointInsideHerTurningCircle) {
    // The second leg ends abreast, half her turning radius off: no rudder brings her there.
    const TargetLayout layout = craft(
        kind.type, kind.length_m, kind.speed_mps,
        {{0.0, 0.0}, {10.0 * kind.length_m, 0.0}, {10.0 * kind.length_m, 1.2 * radius_m()}, {-5000.0, 0.0}});
    TargetState state = startOf(layout);
    for (int i = 0; i < 3600 * kTicksPerSecond && state.leg < 3; ++i) follow(layout, state);
    EXPECT_EQ(state.leg, 3u);
}

TEST_P(TargetOfKind, TheMirroredRouteIsSailedMirrored) {
    const TargetLayout layout =
        craft(kind.type, kind.length_m, kind.speed_mps, {{0.0, 0.0}, {800.0, 100.0}, {900.0, 2000.0}});
    const TargetLayout mirrored =
        craft(kind.type, kind.length_m, kind.speed_mps, {{0.0, 0.0}, {800.0, -100.0}, {900.0, -2000.0}});
    TargetState a = startOf(layout), b = startOf(mirrored);
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) {
        follow(layout, a, {0.1, 0.3});
        follow(mirrored, b, {0.1, -0.3});
        ASSERT_NEAR(a.position.north_m, b.position.north_m, 1e-6);
        ASSERT_NEAR(a.position.east_m, -b.position.east_m, 1e-6);
    }
}

TEST_P(TargetOfKind, FindsHerWaypointsThroughACurrent) {
    const TargetLayout layout =
        craft(kind.type, kind.length_m, kind.speed_mps, {{0.0, 0.0}, {3000.0, 0.0}, {3000.0, 3000.0}});
    TargetState state = startOf(layout);
    for (int i = 0; i < 3 * 3600 * kTicksPerSecond && state.leg < 3; ++i) follow(layout, state, {-0.4, 0.5});
    EXPECT_EQ(state.leg, 3u);
}

TEST(Target, AnOrderedSpeedOverridesTheRoutesAndAStopOverridesBoth) {
    const TargetLayout layout = craft(TargetType::Coaster, 78.0, 4.0, {{0.0, 0.0}, {9000.0, 0.0}});
    TargetState state = startOf(layout);
    state.orderedSpeed_mps = 2.0;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) follow(layout, state);
    EXPECT_NEAR(state.speed_mps, 2.0, 1e-3);
    state.stopped = true;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) follow(layout, state);
    EXPECT_LT(state.speed_mps, 1e-3);
    state.stopped = false;
    state.orderedSpeed_mps = -1.0;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) follow(layout, state);
    EXPECT_NEAR(state.speed_mps, 4.0, 1e-3);
}

TEST(Target, SpeedComesToTheOrderAsAFirstOrderLag) {
    const TargetLayout layout = craft(TargetType::Coaster, 78.0, 4.0, {{0.0, 0.0}, {9000.0, 0.0}});
    TargetState state = startOf(layout);
    state.speed_mps = 0.0;
    const double lag_s = 5.0 + 0.4 * 78.0;
    for (int i = 0; i < static_cast<int>(lag_s * kTicksPerSecond); ++i) follow(layout, state);
    EXPECT_NEAR(state.speed_mps, 4.0 * (1.0 - std::exp(-1.0)), 0.002);  // the step of 20 ms
}

TEST(Target, OneWithoutAWayLiesStill) {
    const TargetLayout layout = craft(TargetType::Fishing, 10.0, 0.0, {{5.0, 6.0}}, TargetBehaviour::Lying);
    TargetState state = startOf(layout);
    for (int i = 0; i < 100 * kTicksPerSecond; ++i) follow(layout, state);
    EXPECT_EQ(state.position, (NorthEast{5.0, 6.0}));
    EXPECT_EQ(state.speed_mps, 0.0);
}

TEST(Target, MassIsThatOfAFullBoat) {
    const TargetLayout layout = craft(TargetType::Coaster, 80.0, 4.0, {{0.0, 0.0}});
    EXPECT_NEAR(layout.mass_kg(), 1025.0 * 0.55 * 80.0 * (80.0 / 6.0) * 4.0, 1.0);
}

TEST(TargetTypeNames, AreThoseOfTheDocuments) {
    const char* names[] = {"fishing", "coaster", "tanker", "container", "ferry", "yacht", "tug", "fastCraft"};
    for (std::size_t i = 0; i < std::size(names); ++i)
        EXPECT_STREQ(targetTypeName(static_cast<TargetType>(i)), names[i]);
}

}  // namespace
}  // namespace sagara::core
