#include "core/bridge/OwnShip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "BridgeShip.h"

namespace sagara::core {
namespace {

using test::BridgeShip;

class EveryOwnShip : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryOwnShip, AtRestInCalmWaterStaysAtRest) {
    BridgeShip s(GetParam(), TelegraphStep::Stop);
    s.run(600.0);
    EXPECT_NEAR(length(s.motion().position()), 0.0, 1e-6);
    EXPECT_NEAR(s.motion().heading_rad, 0.0, 1e-9);
    EXPECT_NEAR(s.motion().down_m, 0.0, 1e-6);
    EXPECT_NEAR(s.motion().roll_rad, 0.0, 1e-9);
    EXPECT_NEAR(s.motion().pitch_rad, 0.0, 1e-9);
}

TEST_P(EveryOwnShip, WithoutWayDriftsWithTheCurrent) {
    BridgeShip s(GetParam(), TelegraphStep::Stop);
    s.current = {0.3, -0.4};
    s.run(600.0);
    EXPECT_NEAR(s.motion().north_m, 0.3 * 600.0, 0.1);
    EXPECT_NEAR(s.motion().east_m, -0.4 * 600.0, 0.1);
}

TEST_P(EveryOwnShip, KeepsTheSpeedItsAdvancePerRevolutionSays) {
    BridgeShip s(GetParam(), TelegraphStep::HalfAhead);
    const double began_mps = s.motion().surge_mps;
    s.run(300.0);
    EXPECT_NEAR(s.motion().surge_mps, began_mps, 0.01 * began_mps);
}

TEST_P(EveryOwnShip, EveryTelegraphStepAheadIsFasterThanTheLast) {
    double before_mps = 0.0;
    for (const TelegraphStep step : {TelegraphStep::DeadSlowAhead, TelegraphStep::SlowAhead,
                                     TelegraphStep::HalfAhead, TelegraphStep::FullAhead}) {
        BridgeShip s(GetParam(), step);
        s.run(3600.0);
        EXPECT_GT(s.motion().surge_mps, before_mps + 0.2);
        before_mps = s.motion().surge_mps;
    }
}

TEST_P(EveryOwnShip, GathersSternwayWithEnginesAstern) {
    BridgeShip s(GetParam(), TelegraphStep::HalfAhead);
    s.order(TelegraphOrder{kAllShafts, TelegraphStep::HalfAstern});
    s.run(3600.0);
    EXPECT_LT(s.motion().surge_mps, -0.5);
}
INSTANTIATE_TEST_SUITE_P(Shipped, EveryOwnShip, ::testing::Values("patrol51", "esso-osaka"),
                         [](const auto& row) {
                             return std::string(row.param) == "patrol51" ? "patrol51" : "essoOsaka";
                         });

TEST(OwnShipStart, LiesAlongsideWithLinesFastAndAnchorsHome) {
    OwnShip ship("own", "Own", test::shippedShip("patrol51").vessel);
    ship.start = {.north_m = 5.0, .east_m = -3.0, .heading_rad = 2.0};
    ship.lineIds = {"head"};
    ship.lines = {{{24.0, -1.6}, {30.0, -10.0}}};
    const OwnShipState state = startOf(ship);
    EXPECT_EQ(state.motion.position(), (NorthEast{5.0, -3.0}));
    EXPECT_EQ(state.lines[0].status, LineStatus::Fast);
    EXPECT_EQ(state.lines[1].status, LineStatus::In);
    EXPECT_EQ(state.anchors[0].status, AnchorStatus::Home);
    EXPECT_EQ(state.autopilot.mode, AutopilotMode::Off);
    EXPECT_EQ(state.autopilot.setHeading_rad, 2.0);
    EXPECT_FALSE(state.pilot.engaged);
    EXPECT_EQ(state.shafts[0].order_rps, 0.0);
}

TEST(OwnShipStart, UnderWayItsShaftsTurnAndReverseLikeAnyOther) {
    OwnShip ship("own", "Own", test::shippedShip("patrol51").vessel);
    ship.start.surge_mps = 5.0;
    ship.startShafts_rps.fill(4.0);
    OwnShipState state = startOf(ship);
    EXPECT_EQ(state.shafts[1].speed_rps, 4.0);
    EXPECT_EQ(state.shafts[1].order_rps, 4.0);
    EXPECT_EQ(state.shafts[2].speed_rps, 0.0);  // she has two
    obey(ship, state, TelegraphOrder{kAllShafts, TelegraphStep::FullAstern});
    double stood_s = 0.0;
    while (state.shafts[0].speed_rps >= 0.0) {
        runShaft(ship.vessel.propulsion.units[0], state.shafts[0], kTick_s);
        if (state.shafts[0].speed_rps == 0.0) stood_s += kTick_s;
        ASSERT_LT(stood_s, 60.0);
    }
    EXPECT_NEAR(stood_s, ship.vessel.propulsion.units[0].reversingTime_s, 3 * kTick_s);
}

}  // namespace
}  // namespace sagara::core
