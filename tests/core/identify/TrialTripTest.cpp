// Documents that load and whose vessels do not sail: what is said, word for word.
#include "core/identify/TrialTrip.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/Assets.h"
#include "tests/support/ShippedVessels.h"

namespace sagara::core {
namespace {

using nlohmann::json;

std::string problemsOf(const std::string& vessel,
                       std::initializer_list<std::pair<const char*, json>> changes) {
    json document = json::parse(test::readAsset("vessels/" + vessel + ".json"));
    for (const auto& [path, value] : changes) document[json::json_pointer(path)] = value;
    const auto loaded = loadSeaworthy(vessel + ".json", document.dump());
    return loaded ? "" : loaded.error().text();
}

class TrialTrip : public ::testing::TestWithParam<std::string> {};
TEST_P(TrialTrip, FindsNothingWithAShippedVessel) { EXPECT_EQ(problemsOf(GetParam(), {}), ""); }
INSTANTIATE_TEST_SUITE_P(Assets, TrialTrip, ::testing::ValuesIn(test::shippedVessels()),
                         [](const auto& row) { return test::testName(row.param); });

TEST(TrialTripOfABadDocument, SaysWhichSpeedIsOutOfReach) {
    EXPECT_EQ(problemsOf("kvlcc2", {{"/propulsion/telegraph_rpm/fullAhead", 1067.1}}),
              "kvlcc2.json: propulsion.telegraph_rpm.fullAhead is 1070, 155 kn (model mmg, thrust at rest "
              "701000 kN, resistance at that speed 477000 kN), expected a speed of 5.44 kn to 60 kn for a "
              "length of 320 m");
    EXPECT_EQ(problemsOf("ferry86", {{"/propulsion/units/0/engine/power_kW", 900}}),
              "ferry86.json: propulsion.units[0].engine gives 32.1 kN m, enough for 181 rpm and 15 kn, "
              "expected torque for full ahead, 267 rpm");
}

TEST(TrialTripOfABadDocument, ComparesResistanceWithFrictionAndWeight) {
    EXPECT_EQ(problemsOf("kvlcc2", {{"/models/0/hull/R0", 0.001}}),
              "kvlcc2.json: models[0] gives a resistance of 1110 kN at 35.1 kn, expected 2800 kN, half the "
              "friction of the hull, to 1410000 kN, 0.45 of her weight");
    EXPECT_EQ(
        problemsOf("patrol51", {{"/model/terms/0/X", -250000.0}}),
        "patrol51.json: propulsion.telegraph_rpm.fullAhead is 420, 2.02 kn (model polynomial, thrust at "
        "rest 291 kN, resistance at that speed 269 kN), expected a speed of 2.18 kn to 45.8 kn for a "
        "length of 51.5 m");
}

TEST(TrialTripOfABadDocument, NamesAWrongSignOfTheRudderAndNoWayAstern) {
    EXPECT_EQ(
        problemsOf("mariner", {{"/models/0/scale/rudderPositive", "turns to starboard"}}),
        "mariner.json: models[0] turns her to port, -0.694 deg/s, with the wheel to starboard, expected "
        "rudder and derivatives of one sign convention: starboard wheel, starboard turn");
    EXPECT_EQ(
        problemsOf("ferry86",
                   {{"/propulsion/units/0/pitch/least", 0.0}, {"/propulsion/units/1/pitch/least", 0.0}}),
        "ferry86.json: propulsion.telegraph_rpm.fullAstern is -241 and gives no way astern, 0 m/s ahead "
        "after a minute, expected thrust astern");
}

TEST(TrialTripOfABadDocument, SaysWhatTheLoaderSaysFirst) {
    EXPECT_EQ(problemsOf("kvlcc2", {{"/hull/depth_m", 2.0}}),
              "kvlcc2.json: hull.depth_m is 2, expected 20.8 to 125 m with a draught of 20.8 m");
}

}  // namespace
}  // namespace sagara::core
