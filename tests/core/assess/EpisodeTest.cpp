#include <gtest/gtest.h>

#include "Rubric.h"

/// What every criterion on something that lasts has in common, shown by the water under the keel.
namespace sagara::core {
namespace {

class Episode : public ::testing::Test {
protected:
    static constexpr double kLimit_m = 1.5;
    test::Judge judge{test::terms(R"("under-keel", "limit_m": 1.5)")};

    void look(double time_s, double underKeel_m) {
        judge.now.underKeel_m = underKeel_m;
        judge.look(time_s);
    }
    void shallow(double from_s, double to_s) {
        for (double t = from_s; t <= to_s + 0.01; t += 0.2) look(t, 1.0);
    }
    void deep(double from_s, double to_s) {
        for (double t = from_s; t <= to_s + 0.01; t += 0.2) look(t, 5.0);
    }
};

TEST_F(Episode, IsOneDeductionWithTheTimeItBeganAndTheWorstOfIt) {
    judge.now.position = {10.0, 20.0};
    look(100.0, 1.4);
    judge.now.position = {11.0, 21.0};
    look(100.2, 0.9);
    judge.now.position = {12.0, 22.0};
    look(100.4, 1.2);
    EXPECT_TRUE(judge.deductions.empty());  // as long as it lasts
    deep(100.6, 106.0);
    ASSERT_EQ(judge.deductions.size(), 1u);
    const Deduction& d = judge.deductions[0];
    EXPECT_EQ(d.time, test::at(100.0));
    EXPECT_EQ(d.place, (NorthEast{11.0, 21.0}));
    EXPECT_EQ(d.value, 0.9);
    EXPECT_EQ(d.limit, kLimit_m);
    EXPECT_EQ(d.points, 4.0);
}

TEST_F(Episode, GoesOnOverAPauseOfLessThanFiveSeconds) {
    shallow(10.0, 10.0);
    deep(10.2, 14.6);
    shallow(14.8, 14.8);
    deep(15.0, 30.0);
    EXPECT_EQ(judge.deductions.size(), 1u);
}

TEST_F(Episode, AfterAPauseOfMoreThanFiveSecondsIsAnother) {
    shallow(10.0, 10.0);
    deep(10.2, 15.2);
    shallow(15.4, 15.4);
    deep(15.6, 30.0);
    ASSERT_EQ(judge.deductions.size(), 2u);
    EXPECT_EQ(judge.deductions[1].time, test::at(15.4));
    EXPECT_EQ(judge.memory.lost, 8.0);
}

TEST_F(Episode, TheWorstOfTheLastOneDoesNotHideTheNext) {
    look(10.0, 0.2);
    deep(10.2, 20.0);
    look(30.0, 1.3);
    deep(30.2, 40.0);
    ASSERT_EQ(judge.deductions.size(), 2u);
    EXPECT_EQ(judge.deductions[1].value, 1.3);
}

TEST_F(Episode, CostsAgainForEveryHalfMinute) {
    shallow(10.0, 39.8);
    judge.close();
    EXPECT_EQ(judge.deductions.at(0).points, 4.0);

    test::Judge longer{test::terms(R"("under-keel", "limit_m": 1.5)")};
    for (double t = 10.0; t < 40.01; t += 0.2) longer.look(t);
    longer.close();
    EXPECT_EQ(longer.deductions.at(0).points, 8.0);
}

/// Every moment of an hour at which there is a look.
class EpisodeAtAnyTime : public Episode {
protected:
    CriterionMemory memory;
    std::vector<Deduction> out;

    void lookAt(std::int64_t time_us, double underKeel_m) {
        Observation now;
        now.time = {time_us};
        now.underKeel_m = underKeel_m;
        judge.criterion->observe(now, {}, memory, out);
    }
    template <typename Check>
    void atEveryLook(Check&& check) {
        for (std::int64_t begin_us = 0; begin_us < 3'600'000'000 && !HasFatalFailure(); begin_us += 200'000) {
            memory = {};
            out.clear();
            check(begin_us);
        }
    }
};

TEST_F(EpisodeAtAnyTime, HalfAMinuteCostsTwice) {
    atEveryLook([&](std::int64_t begin_us) {
        lookAt(begin_us, 1.0);
        lookAt(begin_us + 30'000'000, 1.0);
        judge.criterion->close({}, memory, out);
        ASSERT_EQ(out.at(0).points, 8.0) << begin_us;
    });
}

TEST_F(EpisodeAtAnyTime, FiveSecondsAreAPause) {
    atEveryLook([&](std::int64_t begin_us) {
        lookAt(begin_us, 1.0);
        lookAt(begin_us + 5'000'000, 5.0);
        ASSERT_TRUE(out.empty()) << begin_us;
        lookAt(begin_us + 5'200'000, 5.0);
        ASSERT_EQ(out.size(), 1u) << begin_us;
    });
}

TEST_F(Episode, IsNeverTakenOffBeyondTheWeight) {
    for (int i = 0; i < 4; ++i) {
        look(100.0 * i, 1.0);
        deep(100.0 * i + 0.2, 100.0 * i + 6.0);
    }
    ASSERT_EQ(judge.deductions.size(), 4u);  // what costs nothing any more is still told
    EXPECT_EQ(judge.deductions[0].points, 4.0);
    EXPECT_EQ(judge.deductions[1].points, 4.0);
    EXPECT_EQ(judge.deductions[2].points, 2.0);
    EXPECT_EQ(judge.deductions[3].points, 0.0);
    EXPECT_EQ(judge.memory.lost, 10.0);
}

TEST_F(Episode, ALongOneTakesTheWholeWeightAndNoMore) {
    shallow(0.0, 600.0);
    judge.close();
    EXPECT_EQ(judge.deductions.at(0).points, 10.0);
}

TEST_F(Episode, StillOpenAtTheEndIsCountedOnce) {
    look(10.0, 1.0);
    judge.close();
    judge.close();
    EXPECT_EQ(judge.deductions.size(), 1u);
}

TEST_F(Episode, WithoutABreachThereIsNothingToClose) {
    deep(0.0, 60.0);
    judge.close();
    EXPECT_TRUE(judge.deductions.empty());
    EXPECT_EQ(judge.memory.lost, 0.0);
}

}  // namespace
}  // namespace sagara::core
