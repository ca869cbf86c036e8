#include "ui/hints/Hints.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/exercise/Session.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/hints/HintTexts.h"

namespace sagara::ui {
namespace {

using core::kKnot_mps;

struct Moment {
    core::State state;
    core::Snapshot now;
    Hints hints;
};

Moment after(const std::shared_ptr<const core::World>& world, double seconds) {
    Moment m;
    m.state = core::sailedByPilot(world, 3, core::SimTime{static_cast<std::int64_t>(seconds * 1e6)});
    m.now = core::view(*world, m.state);
    m.hints = hintsFor(*world, m.now, m.state.assessment.route);
    return m;
}

TEST(Hints, AtTheBerthNameTheFirstTaskAndTheHarbourSpeed) {
    const auto world = test::lessonWorld();
    const Hints hints = after(world, 1.0).hints;
    ASSERT_TRUE(hints.task);
    EXPECT_EQ(hints.task->number, 1u);
    EXPECT_EQ(hints.task->of, 5u);
    EXPECT_EQ(hints.task->title, "Single up and spring off");
    ASSERT_TRUE(hints.speedLimit_mps);
    EXPECT_NEAR(*hints.speedLimit_mps, 6.0 * kKnot_mps, 1e-9);
    ASSERT_TRUE(hints.waypoint);
    EXPECT_FALSE(hints.waypoint->time_s) << "she lies still";
}

TEST(Hints, UnderWayGiveBearingDistanceAndTimeToTheNextWaypoint) {
    const auto world = test::lessonWorld();
    const Moment m = after(world, 700.0);
    ASSERT_TRUE(m.hints.waypoint);
    const core::NorthEast here = m.now.ships[0].motion.position();
    const core::NorthEast there = world->route.waypoints[m.hints.waypoint->index].position;
    EXPECT_EQ(m.hints.waypoint->index, m.state.assessment.route.leg);
    EXPECT_NEAR(m.hints.waypoint->distance_m, core::distance(here, there), 1e-9);
    // Five miles from the datum true and grid north differ by less than a hundredth of a degree.
    EXPECT_NEAR(std::remainder(m.hints.waypoint->bearing_rad - core::bearing_rad(here, there), core::kTwoPi),
                0.0, 2e-4);
    ASSERT_TRUE(m.hints.waypoint->time_s);
    const double speed_mps = core::length(m.now.ships[0].overGround_mps);
    EXPECT_GE(*m.hints.waypoint->time_s, 0.999 * m.hints.waypoint->distance_m / speed_mps);
}

TEST(Hints, WarnOfALowerSpeedWithinAMile) {
    const auto world = test::lessonWorld();
    bool warned = false;
    for (const double t : {900.0, 1100.0, 1300.0, 1500.0}) {
        const Moment m = after(world, t);
        if (!m.hints.ahead) continue;
        warned = true;
        EXPECT_LT(m.hints.ahead->limit_mps, m.hints.speedLimit_mps.value_or(1e9));
        EXPECT_LT(m.hints.ahead->in_m, core::kNauticalMile_m);
    }
    EXPECT_TRUE(warned) << "six knots within five cables of the anchorage";
}

TEST(Hints, WithoutMissionAndRouteThereAreNone) {
    const auto world = test::worldOf(test::openWaterScenario(1, 0));
    const Hints hints = hintsFor(*world, core::view(*world, core::startState(*world, 3)));
    EXPECT_FALSE(hints.task);
    EXPECT_FALSE(hints.allDone);
    EXPECT_FALSE(hints.waypoint);
    EXPECT_FALSE(hints.ahead);
    EXPECT_FALSE(hints.track);
    EXPECT_TRUE(hintLines(hints, 0.0).isEmpty());
}

TEST(Hints, WithoutAStateTheNearestPartOfTheRouteIsTaken) {
    const auto world = test::lessonWorld();
    const Moment m = after(world, 700.0);
    const Hints hints = hintsFor(*world, m.now);
    ASSERT_TRUE(hints.waypoint);
    EXPECT_EQ(hints.waypoint->index, m.hints.waypoint->index);
}

TEST(HintTexts, HaveUnitsAndSayWhatIsUrgent) {
    Hints hints;
    hints.speedLimit_mps = 6.0 * kKnot_mps;
    hints.ahead = Hints::SpeedAhead{3.0 * kKnot_mps, 300.0};
    hints.track = Hints::OffTrack{-60.0, 40.0};
    const auto lines = hintLines(hints, 8.2 * kKnot_mps);
    ASSERT_EQ(lines.size(), 3);
    EXPECT_EQ(lines[0].value.toStdString(), "6 kn");
    EXPECT_EQ(lines[0].detail.toStdString(), "she makes 8.2 kn: slow down");
    EXPECT_TRUE(lines[0].urgent);
    EXPECT_EQ(lines[1].detail.toStdString(), "in 300 m");
    EXPECT_TRUE(lines[1].urgent);
    EXPECT_EQ(lines[2].value.toStdString(), "60 m to port of the track");
    EXPECT_TRUE(lines[2].urgent);
    EXPECT_FALSE(hintLines(hints, 2.0 * kKnot_mps)[0].urgent);
}

TEST(HintTexts, RoundAsABridgeDoes) {
    EXPECT_EQ(hintDistance(180.4).toStdString(), "180 m");
    EXPECT_EQ(hintDistance(778.0).toStdString(), "0.42 M");
    EXPECT_EQ(hintDuration(20.0).toStdString(), "under 1 min");
    EXPECT_EQ(hintDuration(250.0).toStdString(), "4 min");
    EXPECT_EQ(hintDuration(3900.0).toStdString(), "1 h 05 min");
}

}  // namespace
}  // namespace sagara::ui
