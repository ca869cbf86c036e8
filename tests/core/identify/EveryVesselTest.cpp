// Every shipped vessel does what ships do: by trend and limits, where no reference tells more.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/identify/CrashStop.h"
#include "core/identify/TrialShip.h"
#include "core/identify/TurningCircle.h"
#include "tests/support/Assets.h"
#include "tests/support/ShippedVessels.h"

namespace sagara::core {
namespace {

class EveryVessel : public ::testing::TestWithParam<std::string> {
protected:
    const Vessel vessel = loadVessel(GetParam(), test::readAsset("vessels/" + GetParam() + ".json")).value();
    TrialShip ship{vessel};
    const double length_s = std::sqrt(vessel.hull.lengthBp_m / kGravity_mps2);  ///< of Froude's scale

    double shaft_rps(TelegraphStep step) const {
        return vessel.propulsion.telegraph_rps[static_cast<std::size_t>(step)];
    }
    void run(double seconds) {
        const double end_s = ship.sample().time_s + seconds;
        while (ship.sample().time_s < end_s) ship.step(0.05);
    }
};

TEST_P(EveryVessel, CastsOffGoesAheadStopsAndBacks) {
    ship.begin({});
    ship.orderShafts(shaft_rps(TelegraphStep::SlowAhead));
    run(100.0 * length_s);
    const double slow_mps = ship.motion().surge_mps;
    EXPECT_GT(slow_mps, 0.2);
    ship.orderShafts(shaft_rps(TelegraphStep::FullAhead));
    run(1000.0 * length_s);
    const double full_mps = ship.motion().surge_mps;
    EXPECT_GT(full_mps, 1.2 * slow_mps);
    EXPECT_NEAR(full_mps, TrialShip(vessel).fullAhead().speed_mps, 0.03 * full_mps);
    ship.orderShafts(0.0);
    run(100.0 * length_s);
    EXPECT_LT(ship.motion().surge_mps, 0.9 * full_mps);
    ship.orderShafts(shaft_rps(TelegraphStep::FullAstern));
    run(600.0 * length_s);
    EXPECT_LT(ship.motion().surge_mps, -0.1 * full_mps);
    EXPECT_GT(ship.motion().surge_mps, -0.9 * full_mps);
    ship.orderShafts(0.0);
    run(1000.0 * length_s);
    EXPECT_LT(std::abs(ship.motion().surge_mps), 0.15 * full_mps);
    EXPECT_TRUE(ship.finite());
}

TEST_P(EveryVessel, MakesMoreSpeedWithEveryStepOfTheTelegraph) {
    double before_mps = 0.0;
    for (const TelegraphStep step : {TelegraphStep::DeadSlowAhead, TelegraphStep::SlowAhead,
                                     TelegraphStep::HalfAhead, TelegraphStep::FullAhead}) {
        ship.begin({});
        const double speed_mps = ship.steadyAt(shaft_rps(step)).speed_mps;
        EXPECT_GT(speed_mps, 1.1 * before_mps);
        before_mps = speed_mps;
    }
}

TEST_P(EveryVessel, StopsFromFullAheadWithinTheLimit) {
    const Trial stop = runCrashStop(ship, {});
    ASSERT_EQ(stop.end, TrialEnd::Completed);
    EXPECT_GT(*stop.measure("track_reach_over_L"), 1.0);
    // MSC.137(76): 15 lengths, 20 where a large displacement makes that impracticable.
    EXPECT_LT(*stop.measure("track_reach_over_L"), vessel.hull.displacement_m3 > 1e5 ? 20.0 : 15.0);
}

TEST_P(EveryVessel, TurnsToBothSidesAndStaysUpright) {
    const bool planes = ship.fullAhead().speed_mps * length_s / vessel.hull.lengthBp_m > 1.5;
    for (const double side : {1.0, -1.0}) {
        TurningCircle turn;
        turn.rudder_rad = side * std::min(35.0 * kDegree_rad, vessel.steering.limit_rad);
        const Trial t = runTurningCircle(ship, turn);
        ASSERT_EQ(t.end, TrialEnd::Completed);
        EXPECT_GT(*t.measure("steady_r_dps") * side, 0.0);
        EXPECT_GT(*t.measure("tactical_diameter_over_L"), 1.0);
        // Mariner's set, of a rudder of old times, turns in 6.4; planing boats turn wide in their lengths.
        EXPECT_LT(*t.measure("tactical_diameter_over_L"), planes ? 12.0 : 7.0);
        EXPECT_LT(*t.measure("max_roll_deg"), 30.0);
        EXPECT_GT(*t.measure("min_roll_deg"), -30.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Assets, EveryVessel, ::testing::ValuesIn(test::shippedVessels()),
                         [](const auto& row) { return test::testName(row.param); });

}  // namespace
}  // namespace sagara::core
