#include "core/bridge/SteeringGear.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/SimTime.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// 35 deg either way at 5 deg/s, no lag.
class Gear : public ::testing::Test {
protected:
    Steering steering;
    SteeringGearState gear;
    double time_s = 0.0;

    void SetUp() override {
        steering.limit_rad = 35.0 * kDegree_rad;
        steering.rate_radps = 5.0 * kDegree_rad;
    }
    double run(double for_s) {
        double mean_rad = 0.0;
        for (const double end_s = time_s + for_s - 1e-9; time_s < end_s; time_s += kTick_s)
            mean_rad = runSteeringGear(steering, gear, kTick_s);
        return mean_rad;
    }
    double angle_deg() const { return gear.angle_rad / kDegree_rad; }
};

TEST_F(Gear, MovesAtItsRateAndStopsAtTheOrder) {
    gear.order_rad = 20.0 * kDegree_rad;
    run(2.0);
    EXPECT_NEAR(angle_deg(), 10.0, 1e-9);
    run(2.0);
    EXPECT_NEAR(angle_deg(), 20.0, 1e-9);
    run(10.0);
    EXPECT_NEAR(angle_deg(), 20.0, 1e-9);
}

TEST_F(Gear, MovesAlikeToBothSides) {
    SteeringGearState port;
    gear.order_rad = 17.0 * kDegree_rad;
    port.order_rad = -gear.order_rad;
    for (int i = 0; i < 500; ++i) {
        const double starboard_rad = runSteeringGear(steering, gear, kTick_s);
        ASSERT_EQ(runSteeringGear(steering, port, kTick_s), -starboard_rad);
    }
}

TEST_F(Gear, GoesNoFartherThanItsLimit) {
    for (const double order_rad : {2.0, -2.0}) {
        gear.order_rad = order_rad;
        run(30.0);
        EXPECT_DOUBLE_EQ(gear.angle_rad, std::copysign(steering.limit_rad, order_rad));
    }
}

TEST_F(Gear, TheHullFeelsTheMeanOfTheTick) {
    gear.order_rad = 0.5;
    const double before_rad = gear.angle_rad, mean_rad = runSteeringGear(steering, gear, kTick_s);
    EXPECT_DOUBLE_EQ(mean_rad, 0.5 * (before_rad + gear.angle_rad));
}

struct Pumps {
    int failed;
    double rate_degps;
};
class GearWithPumps : public Gear, public ::testing::WithParamInterface<Pumps> {};
TEST_P(GearWithPumps, EachMovesTheRudderAtHalfTheRate) {
    gear.pumpsFailed = static_cast<std::uint8_t>(GetParam().failed);
    gear.order_rad = 30.0 * kDegree_rad;
    run(4.0);
    EXPECT_NEAR(angle_deg(), 4.0 * GetParam().rate_degps, 1e-9);
}
INSTANTIATE_TEST_SUITE_P(Failed, GearWithPumps,
                         ::testing::Values(Pumps{0, 5.0}, Pumps{1, 2.5}, Pumps{2, 0.0}, Pumps{255, 0.0}));

TEST_F(Gear, JammedStaysWhereItIsUntilMended) {
    gear.order_rad = 20.0 * kDegree_rad;
    run(2.0);
    gear.jammed = true;
    gear.order_rad = -20.0 * kDegree_rad;
    EXPECT_NEAR(run(20.0) / kDegree_rad, 10.0, 1e-9);
    gear.jammed = false;
    run(6.0);
    EXPECT_NEAR(angle_deg(), -20.0, 1e-9);
}

TEST_F(Gear, WithALagApproachesTheOrderByAnExponential) {
    steering.lag_s = 2.0;
    gear.order_rad = 4.0 * kDegree_rad;  // 2 deg/s at first: the rate is not what holds it back
    run(2.0);
    EXPECT_NEAR(angle_deg(), 4.0 * (1.0 - std::exp(-1.0)), 0.02);  // Euler in steps of a hundredth of the lag
    double last_deg = angle_deg();
    for (int i = 0; i < 1000; ++i) {
        run(kTick_s);
        ASSERT_GE(angle_deg(), last_deg);
        ASSERT_LE(angle_deg(), 4.0);  // never beyond the order
        last_deg = angle_deg();
    }
}

TEST_F(Gear, WithALagIsNeverFasterThanItsRate) {
    steering.lag_s = 1.0;
    gear.order_rad = 35.0 * kDegree_rad;
    for (int i = 0; i < 500; ++i) {
        const double before_rad = gear.angle_rad;
        runSteeringGear(steering, gear, kTick_s);
        ASSERT_LE(gear.angle_rad - before_rad, steering.rate_radps * kTick_s + 1e-15);
    }
}

}  // namespace
}  // namespace sagara::core
