#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

struct Change {
    double along_m, across_m, down_m, roll_rad, pitch_rad, heading_rad;
};

/// What 60 s at sea do to a ship with only these motions free.
Change after(std::uint8_t free) {
    const auto world = test::worldOf(test::openWaterScenario(1, 0));
    State state = startState(*world, 3);
    WeatherOrder slack;
    slack.current = NorthEast{};
    std::vector<Command> commands{{0, 0, slack},
                                  {0, 0, HelmOrder{10.0 * kDegree_rad}},
                                  {0, 0, TelegraphOrder{kAllShafts, TelegraphStep::HalfAhead}},
                                  {0, 0, FreezeMotionOrder{free}}};
    (void)advance(*world, state, commands);
    const ShipMotion begin = state.ships[0].motion;
    for (int i = 0; i < 3000; ++i) (void)advance(*world, state);
    const ShipMotion& end = state.ships[0].motion;
    const BodyPoint moved = HeadingFrame(begin.position(), begin.heading_rad).pointInBody(end.position());
    return {moved.x_m,
            moved.y_m,
            end.down_m - begin.down_m,
            end.roll_rad - begin.roll_rad,
            end.pitch_rad - begin.pitch_rad,
            end.heading_rad - begin.heading_rad};
}

constexpr std::uint8_t bit(FreeMotion motion) { return static_cast<std::uint8_t>(motion); }

TEST(FreeMotions, OneAloneMovesAndNothingElse) {
    const Change surge = after(bit(FreeMotion::Surge));
    EXPECT_GT(surge.along_m, 50.0);
    EXPECT_EQ(surge.heading_rad, 0.0);
    EXPECT_EQ(surge.roll_rad, 0.0);
    EXPECT_EQ(surge.down_m, 0.0);
    EXPECT_NEAR(surge.across_m, 0.0, 1e-6);

    const Change yaw = after(bit(FreeMotion::Yaw));
    EXPECT_NE(yaw.heading_rad, 0.0);
    EXPECT_NEAR(yaw.along_m, 0.0, 1e-9);
    EXPECT_EQ(yaw.pitch_rad, 0.0);

    const Change heave = after(bit(FreeMotion::Heave));
    EXPECT_NE(heave.down_m, 0.0);
    EXPECT_EQ(heave.pitch_rad, 0.0);
    EXPECT_EQ(heave.heading_rad, 0.0);

    const Change roll = after(bit(FreeMotion::Roll));
    EXPECT_NE(roll.roll_rad, 0.0);
    EXPECT_EQ(roll.down_m, 0.0);
    const Change pitch = after(bit(FreeMotion::Pitch));
    EXPECT_NE(pitch.pitch_rad, 0.0);
    EXPECT_EQ(pitch.roll_rad, 0.0);
    const Change sway = after(bit(FreeMotion::Sway));
    EXPECT_NE(sway.across_m, 0.0);
    EXPECT_NEAR(sway.along_m, 0.0, 1e-9);
    EXPECT_EQ(sway.heading_rad, 0.0);
}

TEST(FreeMotions, NoneFreeSheStaysAndAllFreeIsAsIfNothingHadBeenOrdered) {
    const Change none = after(0);
    EXPECT_EQ(none.along_m, 0.0);
    EXPECT_EQ(none.heading_rad, 0.0);
    EXPECT_EQ(none.roll_rad, 0.0);

    const auto world = test::worldOf(test::openWaterScenario(1, 2));
    State with = startState(*world, 3), without = with;
    const std::vector<Command> free{{0, 0, FreezeMotionOrder{0xff}}};
    for (int i = 0; i < 500; ++i) {
        const auto events = advance(*world, with, i == 100 ? free : std::vector<Command>{});
        if (i == 100) {
            ASSERT_EQ(events.size(), 1u);
            EXPECT_EQ(events[0].kind, EventKind::MotionsFreed);
            EXPECT_EQ(events[0].index, kAllMotions);
        }
        (void)advance(*world, without);
    }
    EXPECT_EQ(stateHash(with), stateHash(without));
}

}  // namespace
}  // namespace sagara::core
