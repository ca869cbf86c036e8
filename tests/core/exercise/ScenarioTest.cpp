#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

using test::lessonWith;
using test::problemsOf;

TEST(Scenario, TheLessonBuildsWithoutProblems) { EXPECT_EQ(problemsOf(test::lessonText()), ""); }

TEST(Scenario, SheLiesAtTheBerthAsTheLessonSays) {
    const auto world = test::lessonWorld();
    const OwnShip& ship = *world->ships[0];
    EXPECT_NEAR(ship.start.heading_rad / kDegree_rad, 260.0, 1.0);  // the face of New Pier bears 260
    const Berth& berth = *world->area.findBerth("new-pier");
    // port side on the fenders: half the beam and a fender off the face
    EXPECT_NEAR(distanceTo(berth.face, ship.start.position()), 0.5 * 8.6 + 0.9, 0.01);
    EXPECT_EQ(ship.lines.size(), 4u);
    EXPECT_EQ(formatLocal(world->start, world->area.utcOffset_min), "2027-01-15 09:00:00");
}

TEST(Scenario, EveryProblemIsReportedAtOnceWithItsPath) {
    std::string text = lessonWith("/weather/wind/speed_kn", "\"strong\"");
    text = test::with(text, "/levels/4", "");
    text = test::with(text, "/ownShips/0/lines/1/bollard", "\"np-99\"");
    text = test::with(text, "/mission/tasks/0/keep", "[\"head\", \"breast\"]");
    text = test::with(text, "/mission/criteria/0/wieght", "3");
    const std::string problems = problemsOf(text);
    EXPECT_NE(problems.find("lesson.json: weather.wind.speed_kn is \"strong\", expected 0 to 120 kn"),
              std::string::npos);
    EXPECT_NE(problems.find("lesson.json: levels has 4, expected 5, one for each difficulty"),
              std::string::npos);
    EXPECT_NE(problems.find(
                  "lesson.json: ownShips[0].lines[1].bollard is \"np-99\", expected a bollard of area galle"),
              std::string::npos);
    EXPECT_NE(problems.find(
                  "lesson.json: mission.tasks[0].keep names \"breast\", expected lines of the ship: head, "),
              std::string::npos);
    EXPECT_NE(problems.find("lesson.json: mission.criteria[0].wieght is unknown"), std::string::npos);
}

TEST(Scenario, AMissingVesselOrAreaIsNamed) {
    EXPECT_EQ(problemsOf(lessonWith("/ownShips/0/vessel", "\"titanic\"")),
              "lesson.json: ownShips[0].vessel names \"titanic\", which is not known, expected the id of "
              "vessel in the database");
    EXPECT_EQ(
        problemsOf(lessonWith("/area", "\"atlantis\"")),
        "lesson.json: area names \"atlantis\", which is not known, expected the id of area in the database");
}

TEST(Scenario, NotANumberAndNoTextAreRefused) {
    std::string text = test::lessonText();
    const std::string speed = "\"speed_kn\": 8.5";
    text.replace(text.find(speed), speed.size(), "\"speed_kn\": NaN");
    EXPECT_NE(problemsOf(text).find("lesson.json: is not JSON (parse error at line "), std::string::npos);
    EXPECT_NE(problemsOf(""), "");
    EXPECT_NE(problemsOf("[]"), "");
    EXPECT_NE(problemsOf(lessonWith("/weather/wind/speed_kn", "null")), "");
}

TEST(Scenario, AnUnknownKindSaysWhatThereIs) {
    EXPECT_EQ(problemsOf(lessonWith("/mission/tasks/0/kind", "\"swim\"")),
              "lesson.json: mission.tasks[0].kind is \"swim\", expected one of spring-off, clear-of-berth, "
              "gate, transit, anchor");
}

TEST(Scenario, AStartAgroundIsRefusedWithTheClearance) {
    std::string text = lessonWith("/ownShips/0/berth", "");
    text = test::with(text, "/ownShips/0/lines", "");
    text = test::with(text, "/mission/tasks/0", "");
    text = test::with(text, "/pilot", "[]");
    const auto at = [&](const char* place) {
        return problemsOf(
            test::with(test::with(text, "/ownShips/0/at", place), "/ownShips/0/heading_deg", "0"));
    };
    EXPECT_EQ(at(R"({"lat": 6.0072, "lon": 80.2275})"), "");
    EXPECT_NE(at(R"({"lat": 6.0262, "lon": 80.2202})")
                  .find("lesson.json: ownShips[0] starts aground, under-keel clearance -"),
              std::string::npos);
    EXPECT_NE(at(R"({"lat": 6.0290, "lon": 80.2180})")
                  .find("lesson.json: ownShips[0] starts on land, expected a place with all of her afloat"),
              std::string::npos);
}

TEST(Scenario, ShipsThatStartInEachOtherAreRefused) {
    const std::string boat =
        R"({"id": "inside", "name": "Inside", "type": "fishing", "behaviour": "lying", "length_m": 10,
        "beam_m": 3, "draught_m": 1, "route": [{"at": {"lat": 6.03188, "lon": 80.23042}}]})";
    EXPECT_EQ(problemsOf(lessonWith("/traffic/-", boat)),
              "lesson.json: traffic[12] starts in ownShips[0], expected ships apart");
}

TEST(Scenario, ATargetDoesWhatItSaysOrWhatIsUsual) {
    const auto activityOf = [](const std::string& text, const std::string& id) {
        const auto world = test::worldOf(text);
        for (const TargetLayout& t : world->targets)
            if (t.id == id) return std::string(activityName(t.activity));
        return std::string();
    };
    EXPECT_EQ(activityOf(lessonWith("/traffic/0/activity", "\"towing\""), "coaster"), "towing");
    EXPECT_EQ(activityOf(lessonWith("/traffic/0/activity", ""), "coaster"), "underWay");
    EXPECT_EQ(activityOf(lessonWith("/traffic/6/activity", ""), "yacht-1"), "sailing");
    EXPECT_EQ(activityOf(lessonWith("/traffic/6/activity", "\"underWay\""), "yacht-1"), "underWay");
    EXPECT_EQ(activityOf(lessonWith("/traffic/3/activity", ""), "fishing-3"), "anchored");
    EXPECT_EQ(activityOf(lessonWith("/traffic/3/activity", "\"moored\""), "fishing-3"), "moored");
}

TEST(Scenario, AnActivityThatDoesNotExistOrNeedsALyingVesselIsRefused) {
    EXPECT_EQ(
        problemsOf(lessonWith("/traffic/1/activity", "\"drifting\"")),
        "lesson.json: traffic[1].activity is \"drifting\", expected one of underWay, anchored, fishing, "
        "trawling, towing, notUnderCommand, restricted, moored, sailing");
    EXPECT_EQ(
        problemsOf(lessonWith("/traffic/1/activity", "\"anchored\"")),
        "lesson.json: traffic[1].activity is \"anchored\", expected that of a vessel under way, for she is "
        "not lying");
    EXPECT_NE(problemsOf(lessonWith("/traffic/1/activity", "7")), "");
}

TEST(Scenario, ProblemsOfItsVesselComeUnderTheVesselsName) {
    auto documents = test::documentsOf(test::lessonText());
    documents.vessels[0].text = test::with(documents.vessels[0].text, "/hull/beam_m", "-3");
    const auto world = buildWorld(documents, 1);
    ASSERT_FALSE(world);
    EXPECT_EQ(world.error().text(), "patrol51: hull.beam_m is -3, expected 1 to 80 m");
}

TEST(Scenario, ANewerVersionIsRefused) {
    EXPECT_EQ(problemsOf(lessonWith("/version", "2")),
              "lesson.json: version is 2, expected a whole number from 1 to 1");
}

TEST(Scenario, HoldsSeveralOwnShipsAndManyTargets) {
    const auto world = test::worldOf(test::openWaterScenario(3, 25));
    State state = startState(*world, 3);
    EXPECT_EQ(state.ships.size(), 3u);
    for (int i = 0; i < 3000; ++i) EXPECT_TRUE(advance(*world, state).empty());
    for (const OwnShipState& ship : state.ships) EXPECT_NEAR(ship.motion.surge_mps, 12 * kKnot_mps, 1.5);
}

}  // namespace
}  // namespace sagara::core
