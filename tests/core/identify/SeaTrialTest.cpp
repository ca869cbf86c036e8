#include "core/identify/SeaTrial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

std::vector<std::string> problemsOf(const std::string& text) {
    const auto trial = readSeaTrial("t.csv", text);
    return trial ? std::vector<std::string>() : trial.error().messages();
}

TEST(SeaTrial, UnitsStandInTheNamesOfColumns) {
    const auto trial = readSeaTrial("t.csv",
                                    "# a tanker, calm water\r\n# kind: zigzag\r\n# rudder_deg: 20\r\n"
                                    "# approach_kn: 10\r\n# depth_m: 30\r\n\r\n"
                                    "time_s, heading_deg, rudder_deg, shaft_rpm\r\n"
                                    "0,350,0,60\r\n1,359,,60\r\n2,8,20,60\r\n3,,20,60\r\n4,20,20,60\r\n");
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->kind, TrialKind::Zigzag);
    EXPECT_DOUBLE_EQ(*trial->approach_mps, 10.0 * kKnot_mps);
    EXPECT_EQ(trial->depth_m, 30.0);
    EXPECT_DOUBLE_EQ((*trial)[Channel::Heading][2], 368.0 * kDegree_rad);  // goes on over north
    EXPECT_TRUE(std::isnan((*trial)[Channel::Heading][3]));
    EXPECT_DOUBLE_EQ((*trial)[Channel::Rudder][1], 10.0 * kDegree_rad);  // what drives her has no gaps
    EXPECT_DOUBLE_EQ((*trial)[Channel::Shaft][0], 1.0);
    EXPECT_DOUBLE_EQ(trial->at(Channel::Rudder, 1.5), 15.0 * kDegree_rad);
}

TEST(SeaTrial, AllProblemsOfAFileAreTold) {
    EXPECT_EQ(
        problemsOf("# kind: dance\n# aproach_kn: 12\n# rudder_deg: hard\n"
                   "time_s,heading_deg,heading_deg,colour\n0,1,1,1\n1,x,1,1\n2,1\n"),
        (std::vector<std::string>{
            "t.csv: line 1, kind is \"dance\", expected turning, zigzag, spiral, stopping, speed, decay, "
            "motion-log",
            "t.csv: line 2 \"aproach_kn\" is unknown, expected kind, depth_m, approach_mps, approach_kn, "
            "shaft_rps, shaft_rpm, rudder_deg, heading_deg, wave_heading_deg",
            "t.csv: line 3, rudder_deg is \"hard\", expected -90 to 90",
            "t.csv: line 4 has \"heading_deg\" again, expected each quantity once",
            "t.csv: line 4 has a column \"colour\", expected time_s, x_m, y_m, heading_deg, surge_mps, "
            "sway_mps, "
            "yaw_rate_degps, roll_deg, rudder_deg, shaft_rps, shaft_rpm, speed_mps, speed_kn, pitch_deg, "
            "heave_m, wave_m",
            "t.csv: line 6, heading_deg is \"x\", expected -36000 to 36000",
            "t.csv: line 7 has 2 cells, expected 4 as the names of the columns"}));
}

TEST(SeaTrial, WhatAKindNeedsIsAskedFor) {
    const std::string rows = "0,1\n1,2\n2,3\n3,4\n4,5\n";
    EXPECT_EQ(problemsOf(""),
              (std::vector<std::string>{
                  "t.csv: does not say what it is, expected a line such as \"# kind: turning\"",
                  "t.csv: has no names of columns, expected time_s, x_m, y_m, heading_deg, "
                  "surge_mps, sway_mps, yaw_rate_degps, roll_deg, rudder_deg, shaft_rps, "
                  "shaft_rpm, speed_mps, speed_kn, pitch_deg, heave_m, wave_m"}));
    EXPECT_EQ(problemsOf("# kind: turning\ntime_s,heading_deg\n" + rows),
              (std::vector<std::string>{
                  "t.csv: is a trial of kind turning without it, expected a column rudder_deg "
                  "or a line \"# rudder_deg: ...\"",
                  "t.csv: is a trial of kind turning without it, expected surge_mps, speed_mps "
                  "or speed_kn, or a line \"# approach_mps: ...\""}));
    EXPECT_EQ(
        problemsOf("# kind: motion-log\ntime_s,roll_deg\n" + rows),
        (std::vector<std::string>{
            "t.csv: is a trial of kind motion-log without it, expected wave_m",
            "t.csv: is a trial of kind motion-log without it, expected a line \"# wave_heading_deg: ...\""}));
    EXPECT_EQ(problemsOf("# kind: decay\ntime_s,roll_deg\n0,1\n0,2\n1,3\n2,4\n3,1\n"),
              (std::vector<std::string>{"t.csv: has time_s 0 after 0, expected rising times"}));
    EXPECT_EQ(problemsOf("# kind: decay\ntime_s,roll_deg\n0,1\n"),
              (std::vector<std::string>{"t.csv: has 1 rows, expected at least 5"}));
    EXPECT_TRUE(problemsOf("# kind: speed\nshaft_rpm,speed_kn\n60,8\n").empty());
}

/// No text makes it crash: a good file cut anywhere, and bytes changed at random.
TEST(SeaTrial, AnyTextGivesATrialOrProblems) {
    const std::string good =
        test::readReferenceText("manoeuvring/kvlcc2_marin_trials/zigzag_20.csv").substr(0, 4000);
    for (std::size_t end = 0; end < good.size(); end += 7) (void)readSeaTrial("cut.csv", good.substr(0, end));
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        std::string bad = good;
        for (int k = 0; k < 5; ++k) bad[random.next() % bad.size()] = static_cast<char>(random.next() % 256);
        const auto trial = readSeaTrial("bad.csv", bad);
        EXPECT_TRUE(trial || !trial.error().empty());
    }
}

}  // namespace
}  // namespace sagara::core
