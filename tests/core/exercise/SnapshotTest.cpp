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

TEST(Snapshot, ATargetShowsWhatSheIsDoing) {
    const auto world = test::worldOf(test::lessonWith("/traffic/1/activity", "\"trawling\""));
    State state = startState(*world, 1);
    EXPECT_EQ(view(*world, state).targets.at(1).activity, Activity::Trawling);
    state.targets[1].stopped = true;
    EXPECT_EQ(view(*world, state).targets.at(1).activity, Activity::NotUnderCommand);
}

TEST(Snapshot, AnOwnShipIsMooredAnchoredNotUnderCommandOrUnderWay) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    OwnShipState& ship = state.ships[0];
    const auto now = [&] { return activityOf(view(*world, state).ships[0]); };
    ship.steering.jammed = true;
    EXPECT_EQ(now(), Activity::Moored);  // a fault alongside changes nothing others must know
    for (LineState& line : ship.lines) line.status = LineStatus::In;
    EXPECT_EQ(now(), Activity::NotUnderCommand);
    ship.anchors[0].onBottom = true;
    ship.anchors[0].cableOut_m = 50.0;
    EXPECT_EQ(now(), Activity::Anchored);
    ship.anchors[0] = {};
    ship.steering.jammed = false;
    EXPECT_EQ(now(), Activity::UnderWay);
}

TEST(Snapshot, ShowsOrderedAndAchievedPitchAndDirectionOfTheDrives) {
    const auto worldWith = [](const char* vessel) {
        return test::worldOf(test::with(test::openWaterScenario(1, 0), "/ownShips/0/vessel", vessel));
    };
    const auto ferry = worldWith("\"ferry86\"");
    State state = startState(*ferry, 1);
    ShaftState& shaft = state.ships[0].shafts[1];
    shaft.order_rps = 0.0;
    shaft.pitch = 0.25;
    const auto drive = [&](const World& world) { return view(world, state).ships[0].drives[1]; };
    EXPECT_EQ(drive(*ferry).pitchOrder, 0.0) << "the lever at stop takes the pitch off";
    EXPECT_EQ(drive(*ferry).pitch, 0.25);
    EXPECT_FALSE(drive(*ferry).pitchByHand);
    shaft.pitchByHand = true;
    shaft.pitchOrder = -7.0;
    EXPECT_TRUE(drive(*ferry).pitchByHand);
    EXPECT_EQ(drive(*ferry).pitchOrder, ferry->ships[0]->vessel.propulsion.units[1].pitch->least);

    const auto tug = worldWith("\"tug30\"");
    state = startState(*tug, 1);
    state.ships[0].shafts[1].azimuthOrder_rad = 2.0;
    state.ships[0].shafts[1].azimuth_rad = 1.5;
    EXPECT_EQ(drive(*tug).azimuthOrder_rad, 2.0);
    EXPECT_EQ(drive(*tug).azimuth_rad, 1.5);
    EXPECT_EQ(drive(*tug).pitch, 1.0) << "fixed blades";
}

TEST(Snapshot, OnePumpOrOneEngineOfTwoStillLeavesHerUnderCommand) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    OwnShipState& ship = state.ships[0];
    const auto unable = [&] { return view(*world, state).ships[0].notUnderCommand; };
    ship.steering.pumpsFailed = 1;
    ship.shafts[0].failed = true;
    EXPECT_FALSE(unable());
    ship.shafts[1].failed = true;
    EXPECT_TRUE(unable());
    ship.shafts[0].failed = false;
    EXPECT_FALSE(unable());
    ship.steering.pumpsFailed = 2;
    EXPECT_TRUE(unable());
}

}  // namespace
}  // namespace sagara::core
