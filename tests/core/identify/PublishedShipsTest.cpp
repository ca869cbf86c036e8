#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/identify/CrashStop.h"
#include "core/identify/TrialShip.h"
#include "core/identify/TurningCircle.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

/// Ships whose published sets hold under way ahead only: what they do elsewhere is checked by trend and
/// limits.
class PublishedShip : public ::testing::TestWithParam<const char*> {
protected:
    const Vessel vessel =
        loadVessel(GetParam(), test::readAsset(std::string("vessels/") + GetParam() + ".json")).value();
    TrialShip ship{vessel};

    double shaft_rps(TelegraphStep step) const {
        return vessel.propulsion.telegraph_rps[static_cast<std::size_t>(step)];
    }
    void run(double seconds) {
        const double end_s = ship.sample().time_s + seconds;
        while (ship.sample().time_s < end_s) ship.step(0.1);
    }
};

TEST_P(PublishedShip, StopsFromFullAheadAsShipsDo) {
    const Trial stop = runCrashStop(ship, {});
    ASSERT_EQ(stop.end, TrialEnd::Completed);
    EXPECT_GT(*stop.measure("track_reach_over_L"), 3.0);
    EXPECT_LT(*stop.measure("track_reach_over_L"), 15.0);  // MSC.137(76)
}

TEST_P(PublishedShip, BacksFromRest) {
    const double full_mps = ship.fullAhead().speed_mps;
    ship.begin({});
    ship.orderShafts(shaft_rps(TelegraphStep::FullAstern));
    run(1200.0);
    ASSERT_TRUE(ship.finite());
    EXPECT_LT(ship.motion().surge_mps, -0.4 * full_mps);
    EXPECT_GT(ship.motion().surge_mps, -0.8 * full_mps);
}

TEST_P(PublishedShip, CastsOffAndSteersDeadSlow) {
    ship.begin({});
    ship.orderShafts(shaft_rps(TelegraphStep::DeadSlowAhead));
    ship.orderRudder(20.0 * kDegree_rad);
    run(300.0);
    ASSERT_TRUE(ship.finite());
    EXPECT_GT(ship.motion().surge_mps, 0.2);
    EXPECT_GT(ship.motion().heading_rad, 3.0 * kDegree_rad);
}

TEST_P(PublishedShip, MakesMoreSpeedWithEveryStepOfTheTelegraph) {
    double before_mps = 0.5;
    for (const TelegraphStep step : {TelegraphStep::DeadSlowAhead, TelegraphStep::SlowAhead,
                                     TelegraphStep::HalfAhead, TelegraphStep::FullAhead}) {
        ship.begin({});
        const double speed_mps = ship.steadyAt(shaft_rps(step)).speed_mps;
        EXPECT_GT(speed_mps, 1.1 * before_mps);
        before_mps = speed_mps;
    }
}

TEST_P(PublishedShip, LosesHerWayWithTheEngineStopped) {
    ship.begin(ship.fullAhead());
    const double full_mps = ship.motion().surge_mps;
    ship.orderShafts(0.0);
    run(1800.0);
    ASSERT_TRUE(ship.finite());
    EXPECT_GT(ship.motion().surge_mps, 0.05 * full_mps);
    EXPECT_LT(ship.motion().surge_mps, 0.5 * full_mps);
}

TEST_P(PublishedShip, TurnsWithTheRudderHardOver) {
    for (const double side : {1.0, -1.0}) {
        TurningCircle turn;
        turn.rudder_rad = side * 35.0 * kDegree_rad;
        const Trial t = runTurningCircle(ship, turn);
        ASSERT_EQ(t.end, TrialEnd::Completed);
        EXPECT_GT(*t.measure("steady_r_dps") * side, 0.0);
        EXPECT_GT(*t.measure("tactical_diameter_over_L"), 2.0);
        EXPECT_LT(*t.measure("tactical_diameter_over_L"), 7.0);
        EXPECT_LT(*t.measure("max_roll_deg"), 30.0);
        EXPECT_GT(*t.measure("min_roll_deg"), -30.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Assets, PublishedShip, ::testing::Values("mariner", "sr108", "tanker190k"));

}  // namespace
}  // namespace sagara::core
