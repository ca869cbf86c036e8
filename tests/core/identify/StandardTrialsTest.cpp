#include "core/identify/StandardTrials.h"

#include <gtest/gtest.h>

#include "core/base/Angle.h"
#include "core/identify/TrialShip.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Vessel shipped(const std::string& id) {
    return loadVessel(id, test::readAsset("vessels/" + id + ".json")).value();
}

double reference(const std::string& table, const std::string& key, const std::string& run,
                 const std::string& name) {
    for (const test::Row& row : test::readReference("manoeuvring/" + table))
        if (row.text(key) == run && row.text("measure") == name) return row["value"];
    throw std::runtime_error(name);
}
double patrol(const std::string& run, const std::string& name) {
    return reference("patrol51_measures.csv", "run", run, name);
}

TEST(Patrol51Trials, TurningCircleGivesThePublishedMeasures) {
    const Trial turn = runTurningCircle(shipped("patrol51"), {.rudder_rad = 20.0 * kDegree_rad});
    EXPECT_NEAR(turn.approach_mps, 8.0, 0.005);
    // 0.5 %, the tolerance of the file
    for (const char* name :
         {"advance_over_L", "transfer_over_L", "tactical_diameter_over_L", "steady_diameter_over_L",
          "steady_r_dps", "steady_U_ms", "steady_speed_ratio", "t90_s", "t180_s"}) {
        ASSERT_TRUE(turn.measure(name)) << name;
        EXPECT_NEAR(*turn.measure(name) / patrol("turn_p20", name), 1.0, 0.005) << name;
    }
    EXPECT_NEAR(*turn.measure("steady_drift_deg"), patrol("turn_p20", "steady_beta_deg"), 0.1);
    EXPECT_NEAR(*turn.measure("max_roll_deg"), patrol("turn_p20", "max_roll_deg"), 0.1);
    EXPECT_NEAR(*turn.measure("min_roll_deg"), patrol("turn_p20", "min_roll_deg"), 0.1);
}

TEST(Patrol51Trials, ZigzagGivesThePublishedOvershoots) {
    const Trial zigzag = runZigzag(shipped("patrol51"), Zigzag{});
    ASSERT_EQ(zigzag.end, TrialEnd::Completed);
    for (const char* name : {"overshoot_1_deg", "overshoot_2_deg", "overshoot_3_deg", "overshoot_4_deg"}) {
        ASSERT_TRUE(zigzag.measure(name)) << name;
        EXPECT_NEAR(*zigzag.measure(name), patrol("zz_10_10", name), 0.2) << name;
    }
    for (const char* name : {"execute_2_time_s", "execute_3_time_s", "execute_4_time_s", "execute_5_time_s"})
        EXPECT_NEAR(*zigzag.measure(name), patrol("zz_10_10", name), 0.15) << name;
    EXPECT_NEAR(*zigzag.measure("max_abs_roll_deg"), patrol("zz_10_10", "max_abs_roll_deg"), 0.1);
    EXPECT_EQ(*zigzag.measure("initial_turning_time_s"), *zigzag.measure("execute_2_time_s"));
}

TEST(EssoOsakaTrials, TurnsWithinTenPercentOfThem) {
    TrialShip ship(shipped("esso-osaka"));
    const Approach approach = ship.holding(10.0 * kKnot_mps);
    EXPECT_NEAR(approach.shaft_rps, 51.0 * kRpm_rps, 0.02);
    TrialOptions options;
    options.approach = approach;
    const Trial turn = runTurningCircle(ship, {}, options);
    const auto trials = [](const char* name) {
        return reference("esso_osaka_trials_recalled.csv", "measure", name, name);
    };
    const double advance_m = *turn.measure("advance_over_L") * turn.length_m,
                 diameter_m = *turn.measure("tactical_diameter_over_L") * turn.length_m;
    std::printf(
        "esso-osaka 35 deg from 10 kn: advance %.0f m (trials %.0f), tactical diameter %.0f m "
        "(trials %.0f), speed ratio %.2f (%.2f), drift %.1f deg\n",
        advance_m, trials("advance_m"), diameter_m, trials("tactical_diameter_m"),
        *turn.measure("steady_speed_ratio"), trials("steady_speed_ratio"), *turn.measure("steady_drift_deg"));
    EXPECT_NEAR(advance_m / trials("advance_m"), 1.0, 0.10);  // the aim of issue 5
    EXPECT_NEAR(diameter_m / trials("tactical_diameter_m"), 1.0, 0.10);
}

/// The founding paper's K and tau are illustrative and claim no trial; the bands only keep her a tanker.
TEST(EssoOsakaTrials, FoundingPapersModelSteadies) {
    TrialShip ship(shipped("esso-osaka"), "sandaruwan2010");
    TrialOptions options;
    options.approach = ship.holding(10.0 * kKnot_mps);
    const Trial turn = runTurningCircle(ship, {}, options);
    EXPECT_GT(*turn.measure("tactical_diameter_over_L"), 1.5);
    EXPECT_LT(*turn.measure("tactical_diameter_over_L"), 8.0);
}

double marin(const std::string& manoeuvre, const std::string& name) {
    for (const test::Row& row : test::readReference("manoeuvring/kvlcc2_experiment_measures.csv")) {
        if (row.text("facility") == "MARIN" && row.text("manoeuvre") == manoeuvre &&
            row.text("measure") == name)
            return row["value"];
    }
    throw std::runtime_error(name);
}

/// The published coefficients against the free-running model: bands of issue 5, section 6.
TEST(Kvlcc2Experiment, PublishedCoefficientsComeAsNearAsTheyAreKnownTo) {
    TrialShip ship(shipped("kvlcc2"));
    TrialOptions options;
    options.approach = ship.holding(15.5 * kKnot_mps);
    const Trial turn = runTurningCircle(ship, {}, options);
    const Trial ten = runZigzag(ship, {}, options);
    const Trial twenty =
        runZigzag(ship, {.rudder_rad = 20.0 * kDegree_rad, .switch_rad = 20.0 * kDegree_rad}, options);
    const auto measured = [&](const Trial& trial, const char* manoeuvre, const char* name) {
        std::printf("kvlcc2 %s: %s %.2f (%.2f)\n", manoeuvre, name, *trial.measure(name),
                    marin(manoeuvre, name));
        return *trial.measure(name);
    };
    for (const char* name : {"advance_over_L", "tactical_diameter_over_L"})
        EXPECT_NEAR(measured(turn, "turn 35 starboard", name) / marin("turn 35 starboard", name), 1.0, 0.10);
    const struct {
        const Trial& trial;
        const char *manoeuvre, *name;
        double band_deg;
    } overshoots[] = {{ten, "zigzag 10/10 first to starboard", "overshoot_1_deg", 4.0},
                      {ten, "zigzag 10/10 first to starboard", "overshoot_2_deg", 9.0},
                      {twenty, "zigzag 20/20 first to starboard", "overshoot_1_deg", 4.0}};
    for (const auto& o : overshoots)
        EXPECT_NEAR(measured(o.trial, o.manoeuvre, o.name), marin(o.manoeuvre, o.name), o.band_deg);
}

TEST(StandardTrials, MirrorThemselvesAndStop) {
    std::vector<double> shares;
    const StandardTrials trials =
        runStandardTrials(shipped("patrol51"), [&](double share, const std::string&) {
            shares.push_back(share);
            return true;
        });
    for (const char* name : {"advance_over_L", "tactical_diameter_over_L", "steady_drift_deg"})
        EXPECT_NEAR(*trials.turnPort.measure(name), *trials.turnStarboard.measure(name), 1e-6) << name;
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GT(shares.back(), 0.8);
    EXPECT_LE(shares.back(), 1.0);
    ASSERT_EQ(trials.stop.end, TrialEnd::Completed);
    EXPECT_NEAR(trials.stop.samples.back().surge_mps, 0.0, 0.02);
    EXPECT_NEAR(*trials.stop.measure("track_reach_over_L"), *trials.stop.measure("head_reach_over_L"), 0.05);
}

TEST(StandardTrials, AreCancelledByTheWatcher) {
    int asked = 0;
    const StandardTrials trials =
        runStandardTrials(shipped("esso-osaka"), [&](double, const std::string&) { return ++asked < 10; });
    EXPECT_TRUE(trials.cancelled());
    EXPECT_EQ(asked, 10);
}

TEST(TrialCsv, HasItsColumnsAndARowForEverySample) {
    TrialOptions options;
    options.duration_s = 10.0;
    options.sample_s = 1.0;
    const Trial turn = runTurningCircle(shipped("patrol51"), {.rudder_rad = 20.0 * kDegree_rad}, options);
    const std::string text = trialCsv(turn);
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "time_s,x_m,y_m,heading_deg,surge_mps,sway_mps,yaw_rate_degps,roll_deg,rudder_deg,shaft_rps");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 12);  // head and 0 to 10 s
    EXPECT_EQ(turn.end, TrialEnd::Completed);
}

// tests/reference of the standards: check_values of imo_msc137.json
TEST(ImoStandards, LimitsGoWithLengthOverSpeed) {
    struct Row {
        double length_m, speed_kn, first_deg, second_deg;
    };
    for (const Row& row :
         {Row{320.0, 15.5, 20.0, 40.0}, Row{175.0, 22.15, 12.678843931763112, 29.018265897644667},
          Row{48.0, 17.0, 10.0, 25.0}, Row{160.93, 15.0, 15.427429805615551, 33.141144708423326}}) {
        const ImoLimits limits = imoLimits(row.length_m, row.speed_kn * kKnot_mps);
        EXPECT_NEAR(limits.zigzag10First_deg, row.first_deg, 1e-9);
        EXPECT_NEAR(limits.zigzag10Second_deg, row.second_deg, 1e-9);
    }
}

TEST(ImoStandards, AShipThatDidNotComeSoFarFails) {
    StandardTrials trials;
    trials.turnStarboard.length_m = 100.0;
    trials.turnStarboard.approach_mps = 5.0;
    for (const ImoCheck& check : imoChecks(trials)) EXPECT_FALSE(check.met()) << check.criterion;
}

}  // namespace
}  // namespace sagara::core
