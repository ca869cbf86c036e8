#include "core/identify/ReverseSpiral.h"

#include <gtest/gtest.h>

#include "core/identify/Decay.h"
#include "core/identify/Pullout.h"
#include "core/identify/ReplayShip.h"
#include "core/identify/Spiral.h"
#include "core/identify/TrialShip.h"
#include "core/identify/Zigzag.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Vessel patrol() { return loadVessel("patrol51", test::readAsset("vessels/patrol51.json")).value(); }

TEST(Spiral, OfAStableShipHasNoLoopAndMirrorsItself) {
    TrialShip ship(patrol());
    const Trial trial = runSpiral(ship, {.rudder_rad = 10.0 * kDegree_rad});
    ASSERT_EQ(trial.end, TrialEnd::Completed);
    EXPECT_EQ(trial.measure("spiral_width_deg"), 0.0);
    EXPECT_NEAR(*trial.measure("loop_height_dps"), 0.0, 0.005);
    for (const char* angle : {"5", "1"}) {
        const std::string name = std::string("r_dps_at_") + angle + "_deg_to_port",
                          other = std::string("r_dps_at_-") + angle + "_deg_to_starboard";
        ASSERT_TRUE(trial.measure(name) && trial.measure(other)) << name;
        EXPECT_NEAR(*trial.measure(name), -*trial.measure(other), 1e-3) << name;
        EXPECT_GT(*trial.measure(name), 0.0) << name;
    }
}

/// KVLCC2 is not stable on her course: between the ends of the loop the rudder that holds a turn to starboard
/// is to port. Every angle is where her equations balance; 0.05 deg, for it is a length's mean.
TEST(ReverseSpiral, TellsTheBranchThatTheDirectOneJumpsOver) {
    TrialShip ship(loadVessel("kvlcc2", test::readAsset("vessels/kvlcc2.json")).value());
    TrialOptions options;
    options.approach = ship.holding(7.97);
    options.step_s = 0.2;
    const Trial trial = runReverseSpiral(ship, {}, options);
    ASSERT_EQ(trial.end, TrialEnd::Completed);
    const ReplayShip balance(ship.vessel(), {}, kDeepWater_m);
    int angles = 0;
    for (const TrialMeasure& m : trial.measures) {
        const std::string begin = "rudder_deg_at_";
        if (m.name.rfind(begin, 0) != 0) continue;
        const double r_dps = std::stod(m.name.substr(begin.size()));
        const auto rudder_rad = balance.steadyRudder_rad(r_dps * kDegree_rad, options.approach->shaft_rps,
                                                         7.97, m.value * kDegree_rad);
        ASSERT_TRUE(rudder_rad) << m.name;
        EXPECT_NEAR(m.value, *rudder_rad / kDegree_rad, 0.05) << m.name;
        ++angles;
    }
    EXPECT_EQ(angles, 17);
    const Trial direct = runSpiral(ship, {.rudder_rad = 10.0 * kDegree_rad}, options);
    std::printf("width of the loop: reverse spiral %.2f deg, direct %.2f deg\n",
                *trial.measure("spiral_width_deg"), *direct.measure("spiral_width_deg"));
    // Rates in steps of a sixteenth miss the very ends of the loop; the direct spiral finds them to 0.03 deg.
    EXPECT_NEAR(*trial.measure("spiral_width_deg"), *direct.measure("spiral_width_deg"), 0.15);
    EXPECT_GT(*trial.measure("spiral_width_deg"), 0.0);
}

TEST(Pullout, OfAStableShipEndsOnAStraightCourse) {
    TrialShip ship(patrol());
    const Trial trial = runPullout(ship, {.rudder_rad = -20.0 * kDegree_rad});
    ASSERT_EQ(trial.end, TrialEnd::Completed);
    EXPECT_NEAR(*trial.measure("steady_r_dps"), -2.913, 0.01);  // as in her turning circle
    EXPECT_NEAR(*trial.measure("residual_ratio"), 0.0, 0.001);
}

TEST(TrialShip, GivesAnOrderAtItsHeadingWhateverTheStep) {
    // The first reversal does not wait for the end of a step: it moves by what the integrator makes of a step
    // in which the rudder comes to rest, 1 ms, not by a step.
    const auto reversed_s = [](double step_s) {
        TrialShip ship(patrol());
        TrialOptions options;
        options.approach = ship.holding(8.0);
        options.step_s = step_s;
        return *runZigzag(ship, {}, options).measure("execute_2_time_s");
    };
    EXPECT_NEAR(reversed_s(0.1), reversed_s(0.002), 0.002);
}

TEST(TrialShip, HoldsASpeedWhereThrustBalancesResistance) {
    TrialShip ship(patrol());
    const Approach approach = ship.holding(6.0);
    ship.begin(approach);
    for (int i = 0; i < 1000; ++i) ship.step(0.1);
    EXPECT_NEAR(ship.motion().surge_mps, 6.0, 1e-6);
    ship.begin({6.0, 7.0});  // the published shaft speed is for 8 m/s
    ship.step(1.0);
    EXPECT_GT(ship.motion().surge_mps, 6.05);
}

TEST(Zigzag, OfAGivenDurationGoesOnReversing) {
    TrialShip ship(patrol());
    TrialOptions options;
    options.approach = ship.holding(8.0);
    options.duration_s = 200.0;
    const Trial trial = runZigzag(ship, {}, options);
    EXPECT_NEAR(trial.samples.back().time_s, 200.0, 0.03);
    EXPECT_TRUE(trial.measure("execute_8_time_s"));
}

TEST(Decay, OfThePatrolVesselIsThePublishedOne) {
    TrialShip ship(patrol());
    TrialOptions options;
    options.approach = ship.holding(8.0);
    options.duration_s = 20.0;
    options.sample_s = 0.2;
    const Trial trial = runDecay(ship, {.start = 15.0 * kDegree_rad}, options);
    std::size_t i = 0;
    for (const test::Row& row : test::readReference("manoeuvring/patrol51_roll_decay_8ms_15deg.csv")) {
        if (i >= trial.samples.size()) break;
        EXPECT_NEAR(trial.samples[i].time_s, row["t"], 1e-9);
        EXPECT_NEAR(trial.samples[i].roll_rad / kDegree_rad, row["phi"], 0.1) << row["t"];  // its header
        ++i;
    }
    EXPECT_EQ(i, 101u);
}

TEST(Decay, MeasuresPeriodAndDampingOfHeave) {
    const Vessel vessel = patrol();
    TrialShip ship(vessel);
    const Trial trial = runDecay(ship, {.dof = Decay::Dof::Heave, .start = 0.5});
    ASSERT_TRUE(trial.measure("damping_ratio"));
    // A linear spring with the damping of the document.
    EXPECT_NEAR(*trial.measure("damping_ratio"), vessel.seakeeping.heaveDampingRatio, 0.01);
}

}  // namespace
}  // namespace sagara::core
