#include "core/bridge/MainEngine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/SimTime.h"
#include "core/base/Units.h"
#include "core/bridge/ShaftControl.h"

namespace sagara::core {
namespace {

/// A propeller of 2 m with an engine of 1 MW at 300 rpm.
class MainEngine : public ::testing::Test {
protected:
    MainEngine() {
        const BScrew screw{4, 0.55, 0.9};
        OpenWater water;
        water.screw = screw;
        const auto t = screw.thrustPolynomial(), q = screw.torquePolynomial();
        water.thrust.assign(t.begin(), t.end());
        water.torque.assign(q.begin(), q.end());
        unit.diameter_m = 2.0;
        unit.openWater = water;
        unit.shaftRate_rpsps = 0.5;
        unit.reversingTime_s = 4.0;
        Engine e;
        e.full_rps = 5.0;
        e.torque_Nm = 1e6 / (kTwoPi * e.full_rps);
        e.idle_rps = 1.5;
        e.inertia_kgm2 = 300.0;
        unit.engine = e;
    }
    void run(double order_rps, double inflow_mps, double for_s) {
        const Propeller propeller(unit);
        for (int i = 0; i < std::lround(for_s / kTick_s); ++i)
            runEngine(propeller, shaft, order_rps, {inflow_mps, 1025.0}, kTick_s);
    }
    double torque_Nm(double inflow_mps) const {
        return Propeller(unit).force(shaft.speed_rps, shaft.pitch, inflow_mps, 1025.0).torque_Nm;
    }
    void directDrive(double starts, double refill_s) { unit.engine->startAir = StartAir{starts, refill_s}; }

    PropulsionUnit unit;
    ShaftState shaft;
};

TEST_F(MainEngine, FollowsItsOrderAtItsRateWhereTheTorqueIsThere) {
    run(3.0, 0.0, 2.0);
    EXPECT_NEAR(shaft.speed_rps, 1.0, 0.05);
    run(3.0, 0.0, 20.0);
    EXPECT_NEAR(shaft.speed_rps, 3.0, 1e-6);
}

TEST_F(MainEngine, AtBollardFullAheadIsHeldByItsTorque) {
    run(5.0, 0.0, 60.0);
    EXPECT_LT(shaft.speed_rps, 4.9);
    EXPECT_NEAR(torque_Nm(0.0) / torqueLimit_Nm(*unit.engine, shaft.speed_rps), 0.98, 1e-3)
        << "less friction";
    run(5.0, 5.0, 60.0);
    EXPECT_NEAR(shaft.speed_rps, 5.0, 1e-3) << "with the ship under way there is torque to spare";
}

TEST_F(MainEngine, DoesNotRunSlowerThanIdle) {
    run(0.3, 0.0, 30.0);
    EXPECT_NEAR(shaft.speed_rps, 1.5, 1e-6);
}

TEST_F(MainEngine, StoppedIsTurnedByTheWaterUntilTheShipStops) {
    run(4.0, 5.0, 30.0);
    run(0.0, 5.0, 30.0);
    EXPECT_GT(shaft.speed_rps, 1.5);
    EXPECT_LT(shaft.speed_rps, 3.5);
    EXPECT_NEAR(torque_Nm(5.0), -0.02 * unit.engine->torque_Nm, 60.0) << "friction only";
    run(0.0, 0.2, 60.0);
    EXPECT_EQ(shaft.speed_rps, 0.0);
}

TEST_F(MainEngine, ReversesAfterItsStand) {
    run(4.0, 0.0, 30.0);
    run(-3.0, 0.0, 0.1);
    EXPECT_GT(shaft.speed_rps, 0.0);
    double stood_s = 0.0;
    for (int i = 0; i < 3000 && shaft.speed_rps >= 0.0; ++i) {
        run(-3.0, 0.0, kTick_s);
        if (shaft.speed_rps == 0.0) stood_s += kTick_s;
    }
    EXPECT_NEAR(stood_s, 4.0, 0.1);
    run(-3.0, 0.0, 30.0);
    EXPECT_NEAR(shaft.speed_rps, -3.0, 1e-6);
}

TEST_F(MainEngine, ADirectDriveEngineCannotReverseBeforeTheShipIsSlower) {
    directDrive(10.0, 1e6);
    run(4.5, 7.0, 40.0);
    run(-3.0, 7.0, 60.0);
    EXPECT_GT(shaft.speed_rps, 0.5) << "the water turns it on";
    EXPECT_EQ(shaft.running, false);
    run(-3.0, 2.0, 60.0);
    EXPECT_NEAR(shaft.speed_rps, -3.0, 1e-3);
}

TEST_F(MainEngine, EveryStartTakesAirAndWithoutAirThereIsNone) {
    directDrive(3.0, 100.0);
    unit.engine->startAir->refill_s = 1e9;
    for (int i = 0; i < 3; ++i) {
        run(2.0, 0.0, 20.0);
        EXPECT_NEAR(shaft.speed_rps, 2.0, 1e-6);
        run(0.0, 0.0, 60.0);
        EXPECT_EQ(shaft.speed_rps, 0.0);
        EXPECT_NEAR(*startsLeft(unit, shaft), 2.0 - i, 1e-3);
    }
    run(2.0, 0.0, 30.0);
    EXPECT_EQ(shaft.speed_rps, 0.0);
    unit.engine->startAir->refill_s = 50.0;
    run(2.0, 0.0, 80.0);
    EXPECT_NEAR(shaft.speed_rps, 2.0, 1e-6) << "the compressors have filled up for one";
}

TEST_F(MainEngine, ThatFailedIsTurnedByTheWaterAndStartsWhenMended) {
    run(4.0, 5.0, 30.0);
    shaft.failed = true;
    run(4.0, 5.0, 60.0);
    EXPECT_LT(shaft.speed_rps, 3.5);
    shaft.failed = false;
    run(4.0, 5.0, 60.0);
    EXPECT_NEAR(shaft.speed_rps, 4.0, 1e-3);
}

TEST_F(MainEngine, IsTheSameInLongerSteps) {
    ShaftState other = shaft;
    const Propeller propeller(unit);
    run(4.0, 1.0, 5.0);
    for (int i = 0; i < 20; ++i) runEngine(propeller, other, 4.0, {1.0, 1025.0}, 0.25);
    EXPECT_NEAR(other.speed_rps, shaft.speed_rps, 0.01);
}

TEST(BladesThatTurn, TakePitchFirstThenRevolutions) {
    PropulsionUnit unit;
    unit.pitch = PitchControl{-0.7, 1.0, 0.1, 3.0};
    ShaftState shaft;
    const auto demand = [&](double order_rps) {
        shaft.order_rps = order_rps;
        return demandOf(unit, shaft);
    };
    EXPECT_EQ(demand(5.0).speed_rps, 5.0);
    EXPECT_EQ(demand(5.0).pitch, 1.0);
    EXPECT_EQ(demand(1.5).speed_rps, 3.0);
    EXPECT_EQ(demand(1.5).pitch, 0.5);
    EXPECT_EQ(demand(0.0).pitch, 0.0);
    EXPECT_EQ(demand(-1.5).pitch, -0.5);
    EXPECT_EQ(demand(-4.0).speed_rps, 4.0);
    EXPECT_EQ(demand(-4.0).pitch, -0.7);
    shaft.pitchByHand = true;
    shaft.pitchOrder = 0.2;
    EXPECT_EQ(demand(4.0).pitch, 0.2);
}

TEST(BladesThatTurn, AndDrivesFollowAtTheirRates) {
    PropulsionUnit unit;
    unit.position = {-20.0, 3.0};
    unit.shaftRate_rpsps = 1.0;
    unit.pitch = PitchControl{-0.7, 1.0, 0.1, 3.0};
    unit.azimuth = AzimuthDrive{12.0 * kDegree_rad};
    const std::vector<Propeller> propellers{Propeller(unit)};
    ShaftStates shafts;
    shafts[0].azimuthOrder_rad = 170.0 * kDegree_rad;
    const auto run = [&](double rudder_rad, double for_s) {
        for (int i = 0; i < std::lround(for_s / kTick_s); ++i)
            runShafts(propellers, shafts, {}, rudder_rad, 1025.0, kTick_s);
    };
    run(0.0, 5.0);
    EXPECT_NEAR(shafts[0].azimuth_rad, 60.0 * kDegree_rad, 1e-6);
    EXPECT_NEAR(shafts[0].pitch, 0.5, 1e-6);
    EXPECT_EQ(shafts[0].speed_rps, 3.0) << "the shaft turns with the lever at stop";
    run(0.0, 15.0);
    shafts[0].azimuthOrder_rad = -170.0 * kDegree_rad;
    run(0.0, 2.0);
    EXPECT_NEAR(std::abs(shafts[0].azimuth_rad), 170.0 * kDegree_rad, 1e-6) << "the short way, over astern";
    shafts[0].azimuthOrder_rad = 0.0;
    run(20.0 * kDegree_rad, 20.0);
    EXPECT_NEAR(shafts[0].azimuth_rad, -20.0 * kDegree_rad, 1e-6) << "stern to port, bow to starboard";
}

}  // namespace
}  // namespace sagara::core
