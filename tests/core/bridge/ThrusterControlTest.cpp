#include "core/bridge/ThrusterControl.h"

#include <gtest/gtest.h>

#include "BridgeShip.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

TEST(ThrusterControl, ComesUpInItsRampTimeAndGoesStraightOverToTheOtherSide) {
    const Thruster t{"bow", {20.0, 0.0}, -1.0, 0.8, 16e3, 4.0};
    ThrusterState s;
    s.order = 1.0;
    for (int i = 0; i < 100; ++i) runThruster(t, s, kTick_s);
    EXPECT_NEAR(s.share, 0.5, 1e-9);
    s.order = -1.0;
    for (int i = 0; i < 300; ++i) runThruster(t, s, kTick_s);
    EXPECT_NEAR(s.share, -1.0, 1e-9);
    s.failed = true;
    for (int i = 0; i < 201; ++i) runThruster(t, s, kTick_s);
    EXPECT_NEAR(s.share, 0.0, 1e-9);
}

TEST(ThrusterControl, TurnsThePatrolVesselOnTheSpotAndHardlyAtSevenKnots) {
    test::BridgeShip still("patrol51", TelegraphStep::Stop);
    still.order(ThrusterOrder{0, 1.0});
    still.run(60.0);
    EXPECT_GT(still.motion().heading_rad, 15.0 * kDegree_rad);
    EXPECT_LT(still.motion().yawRate_radps, 3.0 * kDegree_rad) << "no spinning top";
    test::BridgeShip port("patrol51", TelegraphStep::Stop);
    port.order(ThrusterOrder{0, -1.0});
    port.run(60.0);
    EXPECT_NEAR(port.motion().heading_rad, -still.motion().heading_rad, 1e-9);
    test::BridgeShip underWay("patrol51", TelegraphStep::SlowAhead);
    underWay.order(ThrusterOrder{0, 1.0});
    underWay.run(60.0);
    EXPECT_LT(underWay.motion().heading_rad, 0.6 * still.motion().heading_rad);
}

TEST(ThrusterControl, AnOrderIsHeldWithinFullAndAnUnknownOneIgnored) {
    test::BridgeShip s("patrol51", TelegraphStep::Stop);
    s.order(ThrusterOrder{0, 7.0});
    EXPECT_EQ(s.state.thrusters[0].order, 1.0);
    s.order(ThrusterOrder{1, 0.5});
    EXPECT_EQ(s.state.thrusters[1].order, 0.0);
}

}  // namespace
}  // namespace sagara::core
