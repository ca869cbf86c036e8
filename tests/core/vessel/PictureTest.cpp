#include "core/vessel/Picture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

using nlohmann::json;

json good() {
    return json::parse(R"({
        "document": "picture", "version": 1, "id": "barge", "name": "Barge",
        "model": "own/barge.obj", "licence": "CC0-1.0", "forward": "-x", "up": "+z", "fit": "length",
        "waterline_m": 1.5, "midship_m": -2, "leaveOut": ["Wake"], "aroundBridge": ["Mast*"], "detail": ["Rail"],
        "lights": [{"kind": "port", "forward_m": 3, "starboard_m": -2, "height_m": 5}],
        "source": "drawn for this test", "quality": "estimated"})");
}

/// The document with a part replaced, or taken away with an empty value.
json with(const char* pointer, const char* value) {
    json document = good();
    const json::json_pointer at(pointer);
    if (*value == '\0') {
        document.at(at.parent_pointer()).erase(at.back());
    } else {
        document[at] = json::parse(value);
    }
    return document;
}

std::string problemsOf(const json& document) {
    const auto loaded = loadPicture("p.json", document.dump());
    return loaded ? "" : loaded.error().text();
}

TEST(Picture, IsReadWholeFromItsDocument) {
    const auto loaded = loadPicture("p.json", good().dump());
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ(loaded->model, "own/barge.obj");
    EXPECT_EQ(loaded->forward.axis, 0);
    EXPECT_EQ(loaded->forward.sign, -1);
    EXPECT_EQ(loaded->up.axis, 2);
    EXPECT_EQ(loaded->fit, Picture::Fit::Length);
    EXPECT_EQ(loaded->midship_m, -2.0);
    EXPECT_EQ(loaded->leaveOut, std::vector<std::string>{"Wake"});
    const auto& port = loaded->lights[static_cast<std::size_t>(LightPlace::Port)];
    ASSERT_TRUE(port);
    EXPECT_EQ(port->starboard_m, -2.0);
    EXPECT_FALSE(loaded->lights[static_cast<std::size_t>(LightPlace::Stern)]);
}

struct BadRow {
    const char* pointer;
    const char* value;
    const char* problem;
};
const BadRow kBadRows[] = {
    {"/model", "", "p.json: model is missing"},
    {"/model", "\"/etc/passwd\"", "p.json: model is \"/etc/passwd\", expected a file in assets/models"},
    {"/model", "\"../x.ac\"", "p.json: model is \"../x.ac\", expected a file in assets/models"},
    {"/licence", "", "p.json: licence is missing"},
    {"/forward", "\"x\"", "p.json: forward is \"x\", expected one of +x, -x, +y, -y, +z, -z"},
    {"/up", "\"+x\"", "p.json: up lies along \"forward\", expected another axis than \"forward\""},
    {"/fit", "\"beam\"", "p.json: fit is \"beam\", expected one of length, length-and-beam"},
    {"/fit", "", "p.json: scale is missing, expected either \"scale\" or \"fit\""},
    {"/scale", "2", "p.json: scale stands beside \"fit\", expected either \"scale\" or \"fit\""},
    {"/waterline_m", "\"low\"", "p.json: waterline_m is \"low\", expected -10000 to 10000 m"},
    {"/leaveOut", "\"Wake\"", "p.json: leaveOut is \"Wake\", expected a list"},
    {"/lights/0/kind", "\"disco\"",
     "p.json: lights[0].kind is \"disco\", expected one of masthead-forward, "},
    {"/lights/0/height_m", "-1", "p.json: lights[0].height_m is -1, expected 0 to 10000 m"},
    {"/lights/1", R"({"kind": "port", "forward_m": 0, "starboard_m": 0, "height_m": 1})",
     "p.json: lights[1].kind is \"port\" again, expected each kind once"},
    {"/paints", R"([{"objects": ["Hull"], "rgb": [1, 2]}])",
     "p.json: paints[0].rgb is a list of 2, expected a list of 3 "},
    {"/paints", R"([{"rgb": [1, 2, 3]}])", "p.json: paints[0].objects is missing"},
    {"/source", "", "p.json: source is missing"},
    {"/colour", "\"red\"", "p.json: colour is unknown, expected one of "},
    {"/version", "2", "p.json: version is 2, expected a whole number from 1 to 1"},
};

TEST(Picture, EachMistakeIsNamedWithItsPath) {
    for (const BadRow& row : kBadRows) {
        const std::string problems = problemsOf(with(row.pointer, row.value));
        EXPECT_EQ(problems.rfind(row.problem, 0), 0u) << row.pointer << " " << row.value << "\n" << problems;
        EXPECT_EQ(problems.find('\n'), std::string::npos) << problems;
    }
}

TEST(Picture, OfAVesselIsAGroupOfHerDocument) {
    json vessel = json::parse(test::readAsset("vessels/patrol51.json"));
    EXPECT_FALSE(loadVessel("v", vessel.dump())->picture);
    vessel["picture"] = good();
    for (const char* key : {"document", "version", "id", "name"}) vessel["picture"].erase(key);
    EXPECT_EQ(loadVessel("v", vessel.dump())->picture->waterline_m, 1.5);
    vessel["picture"]["up"] = "up";
    EXPECT_EQ(
        loadVessel("v", vessel.dump()).error().text().rfind("v: picture.up is \"up\", expected one of ", 0),
        0u);
}

/// patrol51 with these stations; x, breadth, draught, area, centroid.
std::string problemsWithStations(const json& stations) {
    json vessel = json::parse(test::readAsset("vessels/patrol51.json"));
    vessel["hull"]["stations"] = stations;
    const auto loaded = loadVessel("v", vessel.dump());
    return loaded ? "" : loaded.error().text();
}
json fiveStations() {
    return json::parse(R"([[-25, 6, 1, 3, 1.8], [-12, 8.5, 2.2, 10, 1.4], [0, 8.6, 2.3, 11, 1.3],
                           [13, 6, 2.2, 6, 1.4], [25.7, 0, 0, 0, 2.3]])");
}

TEST(Stations, AreReadInOrderWithTheirNumbers) {
    EXPECT_EQ(problemsWithStations(fiveStations()), "");
    json vessel = json::parse(test::readAsset("vessels/patrol51.json"));
    vessel["hull"]["stations"] = fiveStations();
    const Hull hull = loadVessel("v", vessel.dump())->hull;
    ASSERT_EQ(hull.stations.size(), 5u);
    EXPECT_EQ(hull.stations[1].breadth_m, 8.5);
    EXPECT_EQ(hull.stations[3].area_m2, 6.0);
}

TEST(Stations, EachMistakeIsNamedWithItsRow) {
    const auto expectBegins = [](const json& stations, const std::string& begin) {
        const std::string problems = problemsWithStations(stations);
        EXPECT_EQ(problems.rfind(begin, 0), 0u) << problems;
    };
    json s = fiveStations();
    s[2] = json::array({0, 8.6});
    expectBegins(s, "v: hull.stations[2] is a list of 2, expected a list of 5 numbers from ");
    s = fiveStations();
    s[1][0] = -26;
    expectBegins(s, "v: hull.stations[1] has x_m -26, expected more than the row before, -25 m");
    s = fiveStations();
    s[4][0] = 40;
    expectBegins(
        s, "v: hull.stations[4] has x_m 40, expected at most half of lengthOverall_m from midship, 27 m");
    s = fiveStations();
    s[1][3] = 130;
    expectBegins(s, "v: hull.stations[1] has area_m2 130, expected at most beam by draught, ");
    s = fiveStations();
    s[2][1] = 12;
    expectBegins(s, "v: hull.stations have a greatest breadth of 12 m, expected beam_m, 8.6 m, to 3 %");
    s = fiveStations();
    s.erase(0);
    expectBegins(s, "v: hull.stations has 4 rows, expected 5 to 400");
    expectBegins(json(7), "v: hull.stations is 7, expected a list");
}

}  // namespace
}  // namespace sagara::core
