#include <gtest/gtest.h>

#include "Rubric.h"

namespace sagara::core {
namespace {

using test::Judge;
using test::terms;

TEST(UnderKeelCriterion, IsBrokenBelowItsLimit) {
    Judge judge(terms(R"("under-keel", "limit_m": 1.5)"));
    judge.now.underKeel_m = 1.51;
    EXPECT_FALSE(judge.breaks());
    judge.now.underKeel_m = 1.5;
    EXPECT_FALSE(judge.breaks());
    judge.now.underKeel_m = 1.49;
    EXPECT_TRUE(judge.breaks());
    judge.now.underKeel_m = -0.3;  // aground
    EXPECT_TRUE(judge.breaks());
}

TEST(UnderKeelCriterion, NarrowsToTheDeepestOfSeveral) {
    const Judge one(terms(R"("under-keel", "limit_m": 1.5)")),
        other(terms(R"("under-keel", "limit_m": 2.5)"));
    Limits limits;
    for (const Judge* judge : {&one, &other, &one}) judge->criterion->narrow(limits, {}, {});
    EXPECT_EQ(limits.underKeel_m, 2.5);
    EXPECT_EQ(limits.speedOverGround_mps, 0.0);
}

struct Passing {
    const char* name;
    std::uint32_t leg;
    double clear_m;
    bool inside, outside;
};
/// 50 m inside up to the third waypoint, 463 m (0.25 M) outside from there.
const Passing kPassings[] = {
    {"InsideJustNearer", 1, 49.9, true, false},
    {"InsideAtTheLimit", 1, 50.0, false, false},
    {"InsideJustClear", 1, 50.1, false, false},
    {"TheLastLegInside", 2, 49.9, true, false},
    {"NearerThanOutsideAllowsOnTheLastLegInside", 2, 100.0, false, false},
    {"TheFirstLegOutside", 3, 462.9, false, true},
    {"OutsideAtTheLimit", 3, 463.0, false, false},
    {"OutsideJustClear", 3, 463.1, false, false},
    {"OutsideTouching", 3, 0.0, false, true},
};
class PassingDistance : public ::testing::TestWithParam<Passing> {};

TEST_P(PassingDistance, IsGradedOnItsLegs) {
    Judge inside(terms(R"("passing-distance", "limit_m": 50, "toWaypoint": 3)"));
    Judge outside(terms(R"("passing-distance", "limit_m": 463, "fromWaypoint": 3)"));
    for (Judge* judge : {&inside, &outside}) {
        judge->route.leg = GetParam().leg;
        judge->now.clearOfShips_m = GetParam().clear_m;
    }
    EXPECT_EQ(inside.breaks(), GetParam().inside);
    EXPECT_EQ(outside.breaks(), GetParam().outside);
}
INSTANTIATE_TEST_SUITE_P(InAndOut, PassingDistance, ::testing::ValuesIn(kPassings),
                         [](const auto& row) { return row.param.name; });

TEST(PassingDistanceCriterion, WithoutWaypointsHoldsEverywhere) {
    Judge judge(terms(R"("passing-distance", "limit_m": 50)"));
    judge.now.clearOfShips_m = 49.0;
    for (judge.route.leg = 1; judge.route.leg <= 3; ++judge.route.leg) EXPECT_TRUE(judge.breaks());
}

TEST(PassingDistanceCriterion, OnePassIsOneDeductionOfTheNearest) {
    Judge judge(terms(R"("passing-distance", "limit_m": 50)"));
    for (int i = -100; i <= 100; ++i) {  // she goes by at 4 m/s, 30 m off
        judge.now.position = {0.8 * i, 0.0};
        judge.now.clearOfShips_m = std::hypot(0.8 * i, 30.0);
        judge.look(1000.0 + 0.2 * i);
    }
    judge.close();
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_EQ(judge.deductions[0].value, 30.0);
    EXPECT_EQ(judge.deductions[0].limit, 50.0);
    EXPECT_EQ(judge.deductions[0].place, (NorthEast{}));
    EXPECT_EQ(judge.deductions[0].time, test::at(990.2));  // just nearer than 50 m: 39.2 m before her beam
}

TEST(PassingDistanceCriterion, RefusesAPassageThatEndsBeforeItBegins) {
    const std::string text = R"("passing-distance", "limit_m": 50, "fromWaypoint": 3, "toWaypoint": 3)";
    EXPECT_EQ(test::Rubric().problemsOfCriterion(terms(text)),
              "rubric: toWaypoint is not after fromWaypoint, expected a later one");
}

}  // namespace
}  // namespace sagara::core
