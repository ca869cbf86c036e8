#include <gtest/gtest.h>

#include "Rubric.h"
#include "core/base/Archive.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using Kind = AssessmentEvent::Kind;

/// Two tasks, 60 points to pass; under-keel at most 30, collision fails, parted 10 each.
class Graded : public ::testing::Test {
protected:
    const test::Rubric rubric;
    const Mission mission = rubric.mission(R"({
        "objective": "o", "competenceCode": "c", "briefing": "b", "passScore": 60,
        "tasks": [
            {"id": "gate", "title": "Gate", "kind": "gate", "between": ["gate-west", "gate-east"]},
            {"id": "transit", "title": "Transit", "kind": "transit", "to": "mark", "within_M": 0.2}],
        "criteria": [
            {"id": "keel", "title": "Keel", "kind": "under-keel", "weight": 30, "points": 15, "limit_m": 1.5},
            {"id": "collision", "title": "Collision", "kind": "collision", "weight": 20, "points": 20,
             "fails": true},
            {"id": "gear", "title": "Gear", "kind": "parted", "weight": 60, "points": 10},
            {"id": "deep", "title": "Deep", "kind": "under-keel", "weight": 10, "points": 1, "limit_m": 0.5,
             "fails": true}]})");
    Assessment state = startAssessment(mission);
    std::vector<AssessmentEvent> events;
    Observation now;

    void SetUp() override { now.underKeel_m = 5.0; }
    void look(double time_s, NorthEast position) {
        now.time = test::at(time_s);
        now.position = position;
        assess(mission, rubric.path(), state, now, events);
    }
    void happens(Happening::Kind kind, ContactKind contact = ContactKind::Fender) {
        assess(mission, state, {kind, now.time, {1.0, 2.0}, contact, 0.5, 100.0}, events);
    }
    void sailAll() {
        look(10.0, {490.0, 0.0});
        look(20.0, {510.0, 0.0});
        look(30.0, {2000.0, 900.0});
    }
};

TEST_F(Graded, BeginsWithAHundredPointsAndNothingDone) {
    EXPECT_EQ(scoreOf(state), 100.0);
    EXPECT_FALSE(allTasksDone(state));
    EXPECT_FALSE(passed(mission, state));
}

TEST_F(Graded, TasksAreDoneInTheirOrder) {
    look(10.0, {2000.0, 900.0});  // at the mark, but the gate comes first
    EXPECT_TRUE(events.empty());
    look(20.0, {490.0, 0.0});
    look(30.0, {510.0, 0.0});
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, Kind::TaskDone);
    EXPECT_EQ(events[0].index, 0u);
    EXPECT_EQ(events[0].deduction.time, test::at(30.0));
    EXPECT_EQ(events[0].deduction.place, (NorthEast{510.0, 0.0}));
    EXPECT_EQ(state.currentTask, 1u);
    look(40.0, {2000.0, 900.0});
    EXPECT_EQ(events.back().index, 1u);
    EXPECT_EQ(state.tasks[1].doneAt, test::at(40.0));
    EXPECT_TRUE(allTasksDone(state));
    EXPECT_TRUE(passed(mission, state));
}

TEST_F(Graded, TheScoreIsWhatTheCriteriaHaveLeft) {
    happens(Happening::Kind::LineParted);
    happens(Happening::Kind::LineParted);
    EXPECT_EQ(scoreOf(state), 80.0);
    now.underKeel_m = 1.0;
    look(10.0, {0.0, 0.0});
    closeAssessment(mission, state, now, events);
    EXPECT_EQ(scoreOf(state), 65.0);
    EXPECT_EQ(events.back().kind, Kind::Deduction);
    EXPECT_EQ(events.back().index, 0u);
    EXPECT_EQ(events.back().deduction.points, 15.0);
}

TEST_F(Graded, ThePointsOfAllDeductionsAreWhatIsLost) {
    for (int i = 0; i < 9; ++i) happens(Happening::Kind::CableParted);
    double sum = 0.0;
    for (const AssessmentEvent& e : events) sum += e.deduction.points;
    EXPECT_EQ(sum, 60.0);
    EXPECT_EQ(scoreOf(state), 40.0);
}

TEST_F(Graded, TheScoreIsNeverNegative) {
    for (CriterionMemory& memory : state.criteria) memory.lost = 40.0;
    EXPECT_EQ(scoreOf(state), 0.0);
}

TEST_F(Graded, PassesAtThePassScoreAndNotBelow) {
    sailAll();
    for (int i = 0; i < 4; ++i) happens(Happening::Kind::LineParted);
    EXPECT_EQ(scoreOf(state), 60.0);
    EXPECT_TRUE(passed(mission, state));
    happens(Happening::Kind::LineParted);
    EXPECT_FALSE(passed(mission, state));
}

TEST_F(Graded, DoesNotPassWithATaskLeft) {
    look(10.0, {490.0, 0.0});
    look(20.0, {510.0, 0.0});
    closeAssessment(mission, state, now, events);
    EXPECT_EQ(scoreOf(state), 100.0);
    EXPECT_FALSE(passed(mission, state));
}

TEST_F(Graded, AHardFailIsToldOnceAfterItsDeductionAndIsFinal) {
    sailAll();
    events.clear();
    happens(Happening::Kind::Contact, ContactKind::Ship);
    happens(Happening::Kind::Contact, ContactKind::Ship);
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(events[0].kind, Kind::Deduction);
    EXPECT_EQ(events[1].kind, Kind::Failed);
    EXPECT_EQ(events[1].index, 1u);
    EXPECT_EQ(events[1].deduction.value, 0.5);
    EXPECT_EQ(events[2].kind, Kind::Deduction);
    EXPECT_EQ(events[2].deduction.points, 0.0);
    EXPECT_EQ(scoreOf(state), 80.0);  // enough
    EXPECT_TRUE(state.failed);
    EXPECT_FALSE(passed(mission, state));
}

TEST_F(Graded, AHardFailOfSomethingThatLastsIsToldAtOnce) {
    now.underKeel_m = 0.4;
    look(10.0, {0.0, 0.0});
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, Kind::Failed);
    EXPECT_EQ(events[0].index, 3u);
    EXPECT_EQ(events[0].deduction.value, 0.4);
    EXPECT_EQ(events[0].deduction.limit, 0.5);
    EXPECT_TRUE(state.failed);
}

TEST_F(Graded, GoesOnAfterAFailure) {
    happens(Happening::Kind::Contact, ContactKind::Ship);
    happens(Happening::Kind::LineParted);
    EXPECT_EQ(scoreOf(state), 70.0);
    sailAll();
    EXPECT_TRUE(allTasksDone(state));
}

TEST_F(Graded, ClosedNothingIsGradedAnyMore) {
    closeAssessment(mission, state, now, events);
    const Bytes before = toBytes(state);
    events.clear();
    now.underKeel_m = 0.0;
    sailAll();
    happens(Happening::Kind::Contact, ContactKind::Ship);
    closeAssessment(mission, state, now, events);
    EXPECT_TRUE(events.empty());
    EXPECT_EQ(toBytes(state), before);
}

TEST_F(Graded, HalfWayThroughIsSavedAndGoesOnTheSame) {
    now.underKeel_m = 1.0;
    look(10.0, {490.0, 0.0});
    happens(Happening::Kind::LineParted);
    auto loaded = fromBytes<Assessment>(toBytes(state));
    ASSERT_TRUE(loaded);
    look(20.0, {510.0, 0.0});
    const Bytes went = toBytes(state);
    state = *loaded;
    look(20.0, {510.0, 0.0});
    EXPECT_EQ(toBytes(state), went);
}

TEST(MissionDocument, RefusesTheSameIdTwiceAndUnknownKinds) {
    const test::Rubric rubric;
    EXPECT_EQ(
        rubric.problemsOfCriterion(test::terms(R"("politeness")")),
        "rubric: kind is \"politeness\", expected one of cross-track, speed-limit, time-limit, under-keel, "
        "passing-distance, contact-speed, contact-energy, collision, grounding, parted, anchor-place, "
        "let-go-speed, anchor-drag");
    const std::string twice = test::terms(R"("grounding")") + "," + test::terms(R"("collision")");
    EXPECT_THROW(rubric.mission(R"({"objective": "o", "competenceCode": "c", "briefing": "b", "passScore": 60,
                                    "tasks": [], "criteria": [)" +
                                twice + "]}"),
                 std::runtime_error);
}

TEST(MissionLimits, AreTheNarrowestOfAllCriteria) {
    const test::Rubric rubric;
    const Mission mission = rubric.mission(
        R"({"objective": "o", "competenceCode": "c", "briefing": "b", "passScore": 60, "tasks": [], "criteria": [
        {"id": "a", "title": "A", "kind": "speed-limit", "weight": 9, "points": 3,
         "zones": [{"toWaypoint": 2, "speed_kn": 6}]},
        {"id": "b", "title": "B", "kind": "speed-limit", "weight": 9, "points": 3,
         "zones": [{"toWaypoint": 3, "speed_kn": 8}, {"near": "mark", "within_M": 0.1, "speed_kn": 3}]},
        {"id": "c", "title": "C", "kind": "under-keel", "weight": 9, "points": 3, "limit_m": 1.5},
        {"id": "d", "title": "D", "kind": "cross-track", "weight": 9, "points": 3, "fromWaypoint": 1}]})");
    const auto speed_kn = [&](NorthEast position, std::uint32_t leg) {
        Observation now;
        now.position = position;
        const Limits limits = limitsAt(mission, now, {0.0, 0.0, leg});
        EXPECT_EQ(limits.underKeel_m, 1.5);
        return limits.speedOverGround_mps / kKnot_mps;
    };
    EXPECT_DOUBLE_EQ(speed_kn({}, 1), 6.0);
    EXPECT_DOUBLE_EQ(speed_kn({}, 2), 8.0);
    EXPECT_DOUBLE_EQ(speed_kn({}, 3), 0.0);  // no limit
    EXPECT_DOUBLE_EQ(speed_kn({2000.0, 900.0}, 1), 3.0);
    EXPECT_DOUBLE_EQ(speed_kn({2000.0, 900.0}, 3), 3.0);
}

TEST(Follow, KnowsLegAndSideAllTheWay) {
    const test::Rubric rubric;
    RouteProgress progress;
    for (double along_m = 0.0; along_m < rubric.path().length_m(); along_m += 5.0) {
        const RoutePath::Place place = rubric.path().at(along_m);
        const NorthEast starboard = turnedRight(unitVector(place.course_rad));
        follow(rubric.path(), rubric.path().pointAt(along_m) + 15.0 * starboard, progress);
        ASSERT_NEAR(progress.along_m, along_m, 0.01);
        ASSERT_NEAR(progress.offTrack_m, 15.0, 0.01);
        ASSERT_EQ(progress.leg, place.leg);
    }
    EXPECT_EQ(progress.leg, 3u);
}

TEST(Follow, AShipThatGoesBackALittleIsStillFound) {
    const test::Rubric rubric;
    RouteProgress progress;
    for (double north_m = 0.0; north_m <= 700.0; north_m += 10.0)
        follow(rubric.path(), {north_m, 0.0}, progress);
    for (double north_m = 700.0; north_m >= 400.0; north_m -= 10.0)
        follow(rubric.path(), {north_m, -5.0}, progress);
    EXPECT_NEAR(progress.along_m, 400.0, 1e-9);
    EXPECT_NEAR(progress.offTrack_m, -5.0, 1e-9);
}

TEST(Follow, WithoutARouteThereIsNoProgress) {
    RouteProgress progress;
    follow(RoutePath(), {100.0, 200.0}, progress);
    EXPECT_EQ(progress.along_m, 0.0);
    EXPECT_EQ(progress.offTrack_m, 0.0);
}

}  // namespace
}  // namespace sagara::core
