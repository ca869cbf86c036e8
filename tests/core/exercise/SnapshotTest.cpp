#include "core/exercise/Snapshot.h"

#include <gtest/gtest.h>

#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

TEST(Snapshot, ShowsWhatIsThereAndHidesWhoIsNot) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    for (int i = 0; i < 100; ++i) (void)advance(*world, state);
    const Snapshot s = view(*world, state);
    EXPECT_EQ(s.tick, 100);
    ASSERT_EQ(s.ships.size(), 1u);
    EXPECT_EQ(s.ships[0].lines.size(), 4u);
    EXPECT_EQ(s.ships[0].shafts_rps.size(), 2u);
    EXPECT_EQ(s.targets.size(), 4u);  // level 1: the coaster and three fishing boats
    EXPECT_EQ(s.tasks.size(), 5u);
    EXPECT_EQ(s.score, 100.0);
    EXPECT_GT(s.tide_m, 0.0);
}

TEST(Snapshot, LookingChangesNothing) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 3);
    const auto before = stateHash(state);
    (void)view(*world, state);
    EXPECT_EQ(stateHash(state), before);
}

TEST(Snapshot, TargetsRideTheSwellOutsideAndLieStillInside) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 3);
    double outside = 0.0, inside = 0.0;
    for (int i = 0; i < 3000; ++i) {
        (void)advance(*world, state);
        if (i % 25) continue;
        for (const TargetView& t : view(*world, state).targets) {
            if (world->targets[t.index].id == "fishing-2") outside = std::max(outside, std::abs(t.down_m));
            if (world->targets[t.index].id == "fishing-3") inside = std::max(inside, std::abs(t.down_m));
        }
    }
    EXPECT_GT(outside, 0.3);
    EXPECT_LT(inside, 0.15);
}

}  // namespace
}  // namespace sagara::core
