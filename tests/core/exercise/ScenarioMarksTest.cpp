// Marks and free places of a scenario's own.
#include <gtest/gtest.h>

#include "core/bridge/Radar.h"
#include "core/exercise/World.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

using test::lessonWith;
using test::problemsOf;
using test::with;

/// In the bay, in open water.
constexpr const char* kWreck =
    R"({"id": "wreck", "name": "Wreck", "kind": "isolated-danger", "at": {"lat": 6.018, "lon": 80.228},
        "floating": true, "light": {"character": "Fl(2) W 5s"}})";

std::string withMarks(const std::string& marks) { return lessonWith("/marks", "[" + marks + "]"); }
std::string wreckWith(const std::string& pointer, const std::string& json) {
    return with(withMarks(kWreck), "/marks/0" + pointer, json);
}

TEST(ScenarioMarks, StandAmongThoseOfTheAreaAndOnTheRadar) {
    const auto plain = test::lessonWorld();
    const auto world = test::worldOf(withMarks(kWreck));
    ASSERT_EQ(world->area.marks.size(), plain->area.marks.size() + 1);
    const Mark& mark = world->area.marks.back();
    EXPECT_EQ(mark.id, "wreck");
    EXPECT_EQ(mark.kind, MarkKind::IsolatedDanger);
    EXPECT_TRUE(mark.floating);
    EXPECT_TRUE(mark.fictional) << "in no open source unless the scenario says so";
    EXPECT_LT(distance(mark.position, world->area.frame.toLocal({6.018, 80.228})), 0.01);
    ASSERT_TRUE(mark.light);
    EXPECT_EQ(mark.light->height_m, 4.0);
    EXPECT_EQ(mark.light->range_M, 4.0);
    EXPECT_EQ(radarObjectOf(mark).crossSection_m2, 10.0);
}

TEST(ScenarioMarks, AreNotNeeded) {
    const auto plain = test::lessonWorld(), none = test::worldOf(withMarks(""));
    EXPECT_EQ(none->area.marks.size(), plain->area.marks.size());
}

TEST(ScenarioMarks, SayWhatIsWrongWithThemAndWhere) {
    struct Case {
        std::string text, problem;
    };
    const Case cases[] = {
        {wreckWith("/at", R"({"lat": 6.0285, "lon": 80.2175})"),
         "lesson.json: marks[0].at is on land, expected a place in the water for a mark that floats"},
        {wreckWith("/at", R"({"lat": 9.0, "lon": 80.228})"),
         "lesson.json: marks[0].at is off the chart, expected a place on the chart of "},
        {wreckWith("/at/lat", "99"), "lesson.json: marks[0].at.lat is 99, expected -90 to 90 deg"},
        {wreckWith("/name", R"("No. 1")"),
         "lesson.json: marks[0].name is \"No. 1\", as of another mark of the area, expected a name that no "
         "other mark has"},
        {wreckWith("/id", R"("buoy-1")"),
         "lesson.json: marks[0].id is \"buoy-1\" again, expected an id that no other mark has"},
        {wreckWith("/kind", R"("buoy")"), "lesson.json: marks[0].kind is \"buoy\", expected one of "},
        {wreckWith("/light/character", R"("Flash")"),
         "lesson.json: marks[0].light.character is \"Flash\", expected a light as charts have it: "},
        {wreckWith("/light/character", ""), "lesson.json: marks[0].light.character is missing"},
        {wreckWith("/kind", R"("lighthouse")"),
         "lesson.json: marks[0].floating is true, expected false: lighthouses, leading marks and beacons "
         "stand"},
        {wreckWith("/colour", R"("red")"), "lesson.json: marks[0].colour is unknown"},
        {withMarks(std::string(kWreck) + "," + kWreck),
         "lesson.json: marks[1].name is \"Wreck\", as of another mark, expected a name that no other mark "
         "has"}};
    for (const Case& c : cases)
        EXPECT_NE(problemsOf(c.text).find(c.problem), std::string::npos)
            << c.problem << "\nfound: " << problemsOf(c.text);
}

TEST(ScenarioMarks, ThatStandMayStandOnLand) {
    std::string text = wreckWith("/at", R"({"lat": 6.0285, "lon": 80.2175})");
    text = with(with(text, "/marks/0/floating", "false"), "/marks/0/kind", R"("beacon")");
    EXPECT_EQ(problemsOf(text), "");
}

TEST(FreePlaces, AreWhereTheScenarioSaysInEventsTasksCriteriaAndTheirZones) {
    const std::string here = R"({"lat": 6.018, "lon": 80.228})", there = R"({"lat": 6.018, "lon": 80.23})";
    std::string text = lessonWith("/mission/tasks/2/between", "[" + here + ", " + there + "]");
    text = with(text, "/mission/tasks/3/to", here);
    text = with(text, "/events/0/when", R"({"near": )" + here + R"(, "within_M": 0.2})");
    const auto world = test::worldOf(text);
    const NorthEast place = world->area.frame.toLocal({6.018, 80.228});
    EXPECT_LT(distance(world->events[0].trigger.centre, place), 0.01);
    const auto gate = world->mission.tasks[2]->zone();
    ASSERT_TRUE(gate);
    EXPECT_LT(distance(gate->points[0], place), 0.01);
    const auto circle = world->mission.tasks[3]->zone();
    ASSERT_TRUE(circle);
    EXPECT_LT(distance(circle->points[0], place), 0.01);
}

TEST(FreePlaces, MayStandBesideNamedOnes) {
    const std::string mixed = R"(["s_breakwater_head", {"lat": 6.0338, "lon": 80.228}])";
    EXPECT_EQ(problemsOf(lessonWith("/mission/tasks/2/between", mixed)), "");
}

TEST(FreePlaces, SayWhatIsWrongWithThem) {
    EXPECT_EQ(problemsOf(lessonWith("/mission/tasks/3/to", R"({"lat": 6.018})")),
              "lesson.json: mission.tasks[3].to.lon is missing, expected -180 to 180 deg");
    EXPECT_EQ(problemsOf(lessonWith("/mission/tasks/3/to", R"("atlantis")")),
              "lesson.json: mission.tasks[3].to is \"atlantis\", expected a place of area galle, or a "
              "position with lat and lon");
    EXPECT_EQ(problemsOf(lessonWith("/mission/tasks/2/between", R"(["s_breakwater_head", 5])")),
              "lesson.json: mission.tasks[2].between[1] is 5, expected a text that is not empty");
}

}  // namespace
}  // namespace sagara::core
