#include <gtest/gtest.h>

#include "Rubric.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::Judge;
using test::Rubric;
using test::terms;

std::string task(const std::string& kindAndMore) {
    return R"({"id": "it", "title": "It", "kind": )" + kindAndMore + "}";
}

/// One task in the middle of a run.
struct Doing {
    explicit Doing(const std::string& kindAndMore) : it(Rubric().task(task(kindAndMore))) {}
    std::unique_ptr<const Task> it;
    Observation now;
    TaskMemory memory;
    bool look() { return it->step(now, memory); }
};

constexpr std::uint8_t kHead = 1, kStern = 2, kSpring = 4;

struct SpringOff : ::testing::Test {
    Doing doing{R"("spring-off", "keep": ["head", "spring"], "swing_deg": 12)"};
    void SetUp() override {
        doing.now.heading_rad = 260.0 * kDegree_rad;
        doing.now.linesFast = doing.now.linesOut = kHead | kStern | kSpring;
        ASSERT_FALSE(doing.look());
    }
    bool at(double turned_deg, std::uint8_t fast) {
        doing.now.heading_rad = (260.0 + turned_deg) * kDegree_rad;
        doing.now.linesFast = fast;
        return doing.look();
    }
};

TEST_F(SpringOff, IsSingledUpAndSwungOnTheSpring) {
    EXPECT_FALSE(at(0.0, kHead | kSpring));
    EXPECT_FALSE(at(-11.99, kSpring));
    EXPECT_TRUE(at(-12.01, kSpring));
}

TEST_F(SpringOff, EitherWayRound) { EXPECT_TRUE(at(12.01, kHead | kSpring)); }

TEST_F(SpringOff, IsNotDoneWithALineOutThatIsToBeLetGo) { EXPECT_FALSE(at(-20.0, kHead | kStern | kSpring)); }

TEST_F(SpringOff, IsNotDoneWithNoneOfTheLinesThatSheSwingsOn) { EXPECT_FALSE(at(-20.0, 0)); }

TEST(SpringOffTask, CountsAcrossNorth) {
    Doing doing(R"("spring-off", "keep": ["spring"], "swing_deg": 12)");
    doing.now.heading_rad = 355.0 * kDegree_rad;
    doing.now.linesFast = kSpring;
    EXPECT_FALSE(doing.look());
    doing.now.heading_rad = 6.9 * kDegree_rad;
    EXPECT_FALSE(doing.look());
    doing.now.heading_rad = 7.1 * kDegree_rad;
    EXPECT_TRUE(doing.look());
}

TEST(ClearOfBerthTask, IsAllLinesInAndTheDistance) {
    Doing doing(R"("clear-of-berth", "distance_m": 20)");
    doing.now.clearOfShore_m = 19.99;
    EXPECT_FALSE(doing.look());
    doing.now.clearOfShore_m = 20.0;
    EXPECT_TRUE(doing.look());
    doing.now.linesOut = kSpring;  // cast off, not yet hauled in
    EXPECT_FALSE(doing.look());
    doing.now.linesOut = doing.now.linesFast = kHead;
    EXPECT_FALSE(doing.look());
}

TEST(TaskZones, SayWhereATaskIsToBeDone) {
    const auto gate = Doing(R"("gate", "between": ["gate-west", "gate-east"])").it->zone();
    ASSERT_TRUE(gate);
    EXPECT_EQ(gate->kind, TaskZone::Kind::Gate);
    EXPECT_EQ(gate->points.size(), 2u);
    const auto transit = Doing(R"("transit", "to": "mark", "within_M": 0.2)").it->zone();
    ASSERT_TRUE(transit);
    EXPECT_EQ(transit->kind, TaskZone::Kind::Circle);
    EXPECT_NEAR(transit->radius_m, 0.2 * kNauticalMile_m, 1e-9);
    EXPECT_FALSE(Doing(R"("spring-off", "keep": ["spring"], "swing_deg": 12)").it->zone());
    EXPECT_EQ(Judge(terms(R"("anchor-place", "at": "mark", "limit_m": 50)")).criterion->zones().size(), 1u);
}

/// The gate runs from 100 m west to 100 m east of the route, 500 m along it.
struct Gate : ::testing::Test {
    Doing doing{R"("gate", "between": ["gate-west", "gate-east"])"};
    bool at(double north_m, double east_m = 0.0) {
        doing.now.position = {north_m, east_m};
        return doing.look();
    }
};

TEST_F(Gate, IsPassedOutwardBetweenItsEnds) {
    EXPECT_FALSE(at(490.0));
    EXPECT_FALSE(at(499.9));
    EXPECT_TRUE(at(500.1));
}

TEST_F(Gate, IsPassedJustInsideAnEndAndNotJustOutside) {
    EXPECT_FALSE(at(499.0, 100.1));
    EXPECT_FALSE(at(501.0, 100.1));
    EXPECT_FALSE(at(499.0, 99.9));  // she went back round the end
    EXPECT_TRUE(at(501.0, 99.9));
}

TEST_F(Gate, DoesNotCountInward) {
    EXPECT_FALSE(at(501.0));
    EXPECT_FALSE(at(499.0));
    EXPECT_TRUE(at(501.0));
}

TEST_F(Gate, IsNotPassedByAShipThatLiesOutsideAlready) {
    EXPECT_FALSE(at(600.0));
    EXPECT_FALSE(at(700.0));
}

TEST_F(Gate, IsPassedByAShipThatIsSeenExactlyOnItsLine) {
    bool passed = at(499.0);
    passed = at(500.0) || passed;
    passed = at(501.0) || passed;
    EXPECT_TRUE(passed);
}

TEST_F(Gate, CanBeNamedFromEitherEnd) {
    Doing other(R"("gate", "between": ["gate-east", "gate-west"])");
    for (const double north_m : {499.0, 500.0, 501.0}) {
        other.now.position = {north_m, 0.0};
        if (other.look()) return;
    }
    FAIL() << "not passed";
}

TEST(TransitTask, IsDoneWithinItsDistance) {
    Doing doing(R"("transit", "to": "mark", "within_M": 0.2)");
    doing.now.position = {2000.0, 900.0 - 0.2 * kNauticalMile_m - 0.1};
    EXPECT_FALSE(doing.look());
    doing.now.position.east_m += 0.2;
    EXPECT_TRUE(doing.look());
}

struct Misspelt {
    const char* json;
    const char* problem;
};

TEST(Tasks, SayWhatTheyCannotRead) {
    const Misspelt rows[] = {
        {R"("spring-off", "keep": ["breast"], "swing_deg": 12)",
         "rubric: keep names \"breast\", expected lines of the ship: head, stern, spring"},
        {R"("spring-off", "keep": [], "swing_deg": 12)",
         "rubric: keep is empty, expected the lines to spring off on"},
        {R"("clear-of-berth", "distance_m": 101)", "rubric: distance_m is 101, expected 1 to 100 m"},
        {R"("gate", "between": ["gate-west"])", "rubric: between names 1 places, expected two"},
        {R"("gate", "between": ["gate-west", "pier"])",
         "rubric: between[1] is \"pier\", expected a place of area test, or a position with lat and lon"},
        {R"("transit", "to": "pier", "within_M": 0.2)",
         "rubric: to is \"pier\", expected a place of area test, or a position with lat and lon"},
        {R"("transit", "to": "mark", "within_M": 0.2, "within_m": 3)",
         "rubric: within_m is unknown, expected one of id, kind, title, to, within_M"},
        {R"("anchor", "at": "mark", "within_m": 75, "shackles": [5, 4], "speed_kn": 0.3, "still_s": 60,
             "hold_s": 120, "weather_deg": 30)",
         "rubric: shackles runs downwards, expected [least, most]"},
        {R"("swim")",
         "rubric: kind is \"swim\", expected one of spring-off, clear-of-berth, gate, transit, anchor"},
    };
    for (const Misspelt& row : rows) EXPECT_EQ(Rubric().problemsOfTask(task(row.json)), row.problem);
}

}  // namespace
}  // namespace sagara::core
