#include <gtest/gtest.h>

#include "Rubric.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::Judge;
using test::terms;

struct OffTrack {
    const char* name;
    double along_m;
    std::uint32_t leg;
    double off_m;
    bool broken;
    double limit_m;
};
/// Graded from the second waypoint, 1000 m along. Limits are those of the waypoint the leg ends at.
const OffTrack kOffTrack[] = {
    {"BeforeTheFirstGradedWaypoint", 999.9, 1, 500.0, false, 0.0},
    {"AtItTheLegBehindStillCounts", 1000.0, 1, 30.1, true, 30.0},
    {"StarboardAtTheLimit", 1500.0, 2, 60.0, false, 60.0},
    {"StarboardJustInside", 1500.0, 2, 59.9, false, 60.0},
    {"StarboardJustOutside", 1500.0, 2, 60.1, true, 60.0},
    {"PortAtTheLimit", 1500.0, 2, -50.0, false, 50.0},
    {"PortJustInside", 1500.0, 2, -49.9, false, 50.0},
    {"PortJustOutside", 1500.0, 2, -50.1, true, 50.0},
    {"LastLegToPort", 2500.0, 3, -100.1, true, 100.0},
    {"LastLegToStarboard", 2500.0, 3, 109.9, false, 110.0},
    {"OnTheTrack", 1500.0, 2, 0.0, false, 60.0},
};
class CrossTrack : public ::testing::TestWithParam<OffTrack> {};

TEST_P(CrossTrack, IsGradedByTheCorridorOfItsLegAndSide) {
    const OffTrack& row = GetParam();
    Judge judge(terms(R"("cross-track", "fromWaypoint": 2)"));
    judge.route = {row.along_m, row.off_m, row.leg};
    judge.look(60.0);
    judge.close();
    ASSERT_EQ(judge.deductions.size(), row.broken ? 1u : 0u);
    if (!row.broken) return;
    EXPECT_EQ(judge.deductions[0].value, std::abs(row.off_m));
    EXPECT_EQ(judge.deductions[0].limit, row.limit_m);
}
INSTANTIATE_TEST_SUITE_P(Places, CrossTrack, ::testing::ValuesIn(kOffTrack),
                         [](const auto& row) { return row.param.name; });

TEST(CrossTrackCriterion, TheWorstIsTheFarthestBeyondItsOwnLimit) {
    Judge judge(terms(R"("cross-track", "fromWaypoint": 2)"));
    judge.route = {1900.0, 90.0, 2};  // half as far again as allowed
    judge.look(60.0);
    judge.route = {2500.0, 120.0, 3};  // farther, but hardly outside
    judge.look(60.2);
    judge.close();
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_EQ(judge.deductions[0].value, 90.0);
    EXPECT_EQ(judge.deductions[0].limit, 60.0);
}

TEST(CrossTrackCriterion, IsOverWhenTheAnchorIsLetGo) {
    Judge judge(terms(R"("cross-track", "fromWaypoint": 2)"));
    judge.route = {2500.0, 500.0, 3};
    judge.now.anchors[1].down = true;
    judge.look(60.0);
    judge.close();
    EXPECT_TRUE(judge.deductions.empty());
}

/// 6 kn up to the third waypoint, 10 kn after, 6 kn within 0.25 M and 3 kn within 0.1 M of the mark.
const std::string kZones = terms(R"("speed-limit", "zones": [
    {"toWaypoint": 3, "speed_kn": 6}, {"toWaypoint": 4, "speed_kn": 10},
    {"near": "mark", "within_M": 0.25, "speed_kn": 6}, {"near": "mark", "within_M": 0.1, "speed_kn": 3}])");
constexpr NorthEast kMark{2000.0, 900.0};

struct Zone {
    const char* name;
    std::uint32_t leg;
    double offMark_M;
    double limit_kn;
};
const Zone kPlaces[] = {
    {"FirstLeg", 1, 1.0, 6.0},
    {"LastLegOfTheZone", 2, 1.0, 6.0},
    {"LegAfterTheZone", 3, 0.26, 10.0},
    {"JustInsideTheWideCircle", 3, 0.249, 6.0},
    {"OutsideTheNarrow", 3, 0.101, 6.0},
    {"JustInsideTheNarrow", 3, 0.099, 3.0},
    {"NarrowCircleOnAnEarlyLeg", 1, 0.05, 3.0},
};
class SpeedZones : public ::testing::TestWithParam<Zone> {
protected:
    Judge judge{kZones};
    void SetUp() override {
        judge.route.leg = GetParam().leg;
        judge.now.position = kMark - NorthEast{0.0, GetParam().offMark_M * kNauticalMile_m};
    }
    void go(double speed_kn) { judge.now.overGround_mps = kKnot_mps * speed_kn * unitVector(2.0); }
};

TEST_P(SpeedZones, TheLowestThatHoldsIsTheLimit) {
    Limits limits;
    judge.criterion->narrow(limits, judge.now, judge.route);
    EXPECT_DOUBLE_EQ(limits.speedOverGround_mps, GetParam().limit_kn * kKnot_mps);
    go(GetParam().limit_kn);
    EXPECT_FALSE(judge.breaks());
    go(GetParam().limit_kn + 0.09);  // the GPS shows tenths
    EXPECT_FALSE(judge.breaks());
    go(GetParam().limit_kn + 0.11);
    EXPECT_TRUE(judge.breaks());
}

TEST_P(SpeedZones, ADeductionSaysHowFastAndWhatWasAllowed) {
    go(GetParam().limit_kn + 1.0);
    judge.look(5.0);
    go(GetParam().limit_kn + 2.0);
    judge.look(5.2);
    go(GetParam().limit_kn + 0.5);
    judge.look(5.4);
    judge.close();
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_NEAR(judge.deductions[0].value, (GetParam().limit_kn + 2.0) * kKnot_mps, 1e-12);
    EXPECT_NEAR(judge.deductions[0].limit, GetParam().limit_kn * kKnot_mps, 1e-12);
}
INSTANTIATE_TEST_SUITE_P(Places, SpeedZones, ::testing::ValuesIn(kPlaces),
                         [](const auto& row) { return row.param.name; });

TEST(SpeedLimitCriterion, SternwayAndDriftCountLikeHeadway) {
    Judge judge(kZones);
    judge.route.leg = 1;
    judge.now.overGround_mps = {0.0, -7.0 * kKnot_mps};
    judge.now.heading_rad = 0.0;
    EXPECT_TRUE(judge.breaks());
}

TEST(SpeedLimitCriterion, WhatTheSwellAddsDoesNotCount) {
    Judge judge(kZones);
    judge.route.leg = 1;
    judge.now.overGround_mps = {5.9 * kKnot_mps, 0.0};
    judge.now.momentarySpeed_mps = 6.4 * kKnot_mps;
    EXPECT_FALSE(judge.breaks());
}

TEST(SpeedLimitCriterion, OutsideAllZonesThereIsNone) {
    Judge judge(terms(R"("speed-limit", "zones": [{"toWaypoint": 2, "speed_kn": 6}])"));
    judge.route.leg = 2;
    judge.now.overGround_mps = {30.0, 0.0};
    EXPECT_FALSE(judge.breaks());
    Limits limits;
    judge.criterion->narrow(limits, judge.now, judge.route);
    EXPECT_EQ(limits.speedOverGround_mps, 0.0);
}

class TimeLimit : public ::testing::Test {
protected:
    Judge judge{terms(R"("time-limit", "fails": true, "limit_min": [45, 40, 35, 31, 28])")};
};

TEST_F(TimeLimit, RunsFromTheFirstLineLetGo) {
    judge.now.linesFast = 0b1111;
    judge.now.linesOut = 0b1111;
    judge.look(0.2);
    judge.look(600.0);  // she lies and waits
    judge.now.linesFast = 0b0111;
    judge.look(600.2);
    judge.now.position = {3.0, 4.0};
    judge.look(600.2 + 45 * 60);
    EXPECT_TRUE(judge.deductions.empty());  // to the second
    EXPECT_FALSE(judge.memory.broken);
    judge.look(600.4 + 45 * 60);
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_TRUE(judge.memory.broken);
    EXPECT_EQ(judge.deductions[0].time, test::at(600.4 + 45 * 60));
    EXPECT_EQ(judge.deductions[0].place, (NorthEast{3.0, 4.0}));
    EXPECT_NEAR(judge.deductions[0].value, 45 * 60 + 0.2, 1e-9);
    EXPECT_EQ(judge.deductions[0].limit, 45 * 60);
    EXPECT_EQ(judge.deductions[0].points, 4.0);
}

TEST_F(TimeLimit, BreaksOnce) {
    for (double t = 0.2; t < 2 * 45 * 60; t += 1.0) judge.look(t);
    EXPECT_EQ(judge.deductions.size(), 1u);
}

TEST_F(TimeLimit, WithoutLinesItRunsFromTheStart) {
    judge.look(0.2);
    judge.look(0.2 + 45 * 60);
    EXPECT_TRUE(judge.deductions.empty());
    judge.look(0.4 + 45 * 60);
    EXPECT_EQ(judge.deductions.size(), 1u);
}

TEST_F(TimeLimit, WaitsForAsLongAsNoLineIsLetGo) {
    judge.now.linesFast = 0b0011;
    judge.look(0.2);
    judge.look(3 * 3600.0);
    EXPECT_TRUE(judge.deductions.empty());
}

TEST_F(TimeLimit, IsThatOfTheLevel) {
    const double limit_min[] = {45, 40, 35, 31, 28};
    for (int level = 1; level <= 5; ++level) {
        Judge atLevel(terms(R"("time-limit", "limit_min": [45, 40, 35, 31, 28])"));
        atLevel.now.level = level;
        atLevel.look(10.0);
        atLevel.look(10.0 + 60.0 * limit_min[level - 1]);
        EXPECT_TRUE(atLevel.deductions.empty()) << level;
        atLevel.look(10.2 + 60.0 * limit_min[level - 1]);
        ASSERT_EQ(atLevel.deductions.size(), 1u) << level;
        EXPECT_EQ(atLevel.deductions[0].limit, 60.0 * limit_min[level - 1]);
    }
}

TEST_F(TimeLimit, ChangesWithTheLevelDuringTheRun) {
    judge.look(0.2);
    judge.now.level = 5;
    judge.look(30 * 60.0);  // over at level 5, not at level 1
    EXPECT_EQ(judge.deductions.at(0).limit, 28 * 60.0);
}

TEST_F(TimeLimit, IsTheSameWheneverItBegins) {
    for (std::int64_t begin_us = 0; begin_us < 3'600'000'000; begin_us += 200'000) {
        judge.memory = {};
        judge.deductions.clear();
        judge.look(SimTime{begin_us});
        judge.look(SimTime{begin_us + 45 * 60'000'000LL});
        ASSERT_TRUE(judge.deductions.empty()) << begin_us;
        judge.look(SimTime{begin_us + 45 * 60'000'000LL + 200'000});
        ASSERT_EQ(judge.deductions.size(), 1u) << begin_us;
    }
}

}  // namespace
}  // namespace sagara::core
