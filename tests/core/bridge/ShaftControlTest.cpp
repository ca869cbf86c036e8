#include "core/bridge/ShaftControl.h"

#include <gtest/gtest.h>

#include "core/base/SimTime.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// 0.5 rps each second, 3 s between ahead and astern.
class Shaft : public ::testing::Test {
protected:
    PropulsionUnit unit;
    ShaftState shaft;

    void SetUp() override {
        unit.shaftRate_rpsps = 0.5;
        unit.reversingTime_s = 3.0;
    }
    void run(double for_s) {
        for (int i = 0; i < std::lround(for_s / kTick_s); ++i) runShaft(unit, shaft, kTick_s);
    }
    /// Time until the shaft turns the way it is ordered.
    double untilTurning_s() {
        double time_s = 0.0;
        for (; shaft.speed_rps * shaft.order_rps <= 0.0 && time_s < 100.0; time_s += kTick_s)
            runShaft(unit, shaft, kTick_s);
        return time_s;
    }
};

TEST_F(Shaft, FollowsItsOrderAtItsRate) {
    shaft.order_rps = 2.0;
    run(1.0);
    EXPECT_NEAR(shaft.speed_rps, 0.5, 1e-9);
    run(3.0);
    EXPECT_NEAR(shaft.speed_rps, 2.0, 1e-9);
    run(10.0);
    EXPECT_EQ(shaft.speed_rps, 2.0);
    shaft.order_rps = 1.0;
    run(1.0);
    EXPECT_NEAR(shaft.speed_rps, 1.5, 1e-9);
}

TEST_F(Shaft, GoesAsternAsWell) {
    shaft.order_rps = -1.0;
    run(2.0);
    EXPECT_NEAR(shaft.speed_rps, -1.0, 1e-9);
}

TEST_F(Shaft, StopsAtItsRate) {
    shaft.order_rps = shaft.speed_rps = 2.0;
    run(0.02);
    shaft.order_rps = 0.0;
    run(2.0);
    EXPECT_NEAR(shaft.speed_rps, 1.0, 1e-9);
    run(2.0);
    EXPECT_NEAR(shaft.speed_rps, 0.0, 1e-9);
    run(2.0);
    EXPECT_EQ(shaft.speed_rps, 0.0);
}

class Reversing : public Shaft, public ::testing::WithParamInterface<double> {};
TEST_P(Reversing, StandsBetweenAheadAndAstern) {
    shaft.order_rps = GetParam();
    run(4.0);
    ASSERT_NEAR(shaft.speed_rps, GetParam(), 1e-9);
    shaft.order_rps = -GetParam();
    run(1.98);
    EXPECT_GT(shaft.speed_rps * GetParam(), 0.0);
    run(1.0);
    EXPECT_EQ(shaft.speed_rps, 0.0);
    run(1.96);
    EXPECT_EQ(shaft.speed_rps, 0.0);
    run(0.12);  // a tick or two for the turn from one to the other
    EXPECT_LT(shaft.speed_rps * GetParam(), 0.0);
    run(4.0);
    EXPECT_NEAR(shaft.speed_rps, -GetParam(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(EitherWay, Reversing, ::testing::Values(1.0, -1.0));

TEST_F(Shaft, NeverPassesThroughZeroWithoutAStand) {
    shaft.order_rps = 1.0;
    run(4.0);
    for (int change = 0; change < 40; ++change) {  // a nervous hand on the lever
        shaft.order_rps = change % 2 ? 1.0 : -1.0;
        for (int i = 0; i < 30 * (change % 7); ++i) {
            const double before_rps = shaft.speed_rps;
            runShaft(unit, shaft, kTick_s);
            ASSERT_GE(before_rps * shaft.speed_rps, 0.0);
            ASSERT_LE(std::abs(shaft.speed_rps - before_rps), 0.5 * kTick_s + 1e-12);
        }
    }
}

TEST_F(Shaft, ThatWasOnlyStoppedTurnsAheadAgainAtOnce) {
    shaft.order_rps = 1.0;
    run(4.0);
    shaft.order_rps = 0.0;
    run(4.0);
    shaft.order_rps = 1.0;
    EXPECT_LE(untilTurning_s(), kTick_s);
}

TEST_F(Shaft, ThatHasStoodLongerThanTheReversingTimeTurnsAsternAtOnce) {
    shaft.order_rps = 1.0;
    run(4.0);
    shaft.order_rps = 0.0;
    run(60.0);
    shaft.order_rps = -1.0;
    EXPECT_LE(untilTurning_s(), 2 * kTick_s);
}

TEST_F(Shaft, ThatHasStoodForAPartOfTheReversingTimeWaitsForTheRest) {
    shaft.order_rps = 1.0;
    run(4.0);
    shaft.order_rps = 0.0;
    run(2.0 + 1.0);  // runs down, stands a second
    ASSERT_NEAR(shaft.speed_rps, 0.0, 1e-9);
    shaft.order_rps = -1.0;
    EXPECT_NEAR(untilTurning_s(), 2.0, 3 * kTick_s);
}

TEST_F(Shaft, WithAFailedEngineRunsDownAtAThirdOfTheRateAndStaysStopped) {
    shaft.order_rps = 1.0;
    run(4.0);
    shaft.failed = true;
    run(3.0);
    EXPECT_NEAR(shaft.speed_rps, 0.5, 1e-9);
    run(3.0);
    EXPECT_NEAR(shaft.speed_rps, 0.0, 1e-9);
    shaft.order_rps = -1.0;  // the telegraph does nothing
    run(60.0);
    EXPECT_NEAR(shaft.speed_rps, 0.0, 1e-9);
}

TEST_F(Shaft, MendedGoesBackToItsOrder) {
    shaft.order_rps = 1.0;
    shaft.failed = true;
    run(60.0);
    EXPECT_EQ(shaft.speed_rps, 0.0);
    shaft.failed = false;
    run(2.0);
    EXPECT_NEAR(shaft.speed_rps, 1.0, 1e-9);
}

}  // namespace
}  // namespace sagara::core
