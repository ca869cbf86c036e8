#include "core/world/Area.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Random.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

/// The smallest document that loads, with a pair of grids of each kind.
const std::string kPond = R"({
  "document": "area", "version": 1, "id": "pond", "name": "Pond", "notice": "Not for navigation.",
  "attribution": ["us"], "datum": {"lat": 6.0, "lon": 80.0}, "timeZone": "Asia/Colombo", "utcOffset_min": 330,
  "ialaRegion": "A", "depthDatum": "LAT", "depthSource": "modelled: flat", "waveDepth_m": 20, "holdingRatio": 1,
  "tide": {"source": "a book", "meanAboveDatum_m": 0.5,
           "constituents": [{"name": "M2", "amplitude_m": 0.2, "phaseLag_deg": 90}]},
  "land": [{"points": [[6.01, 80.0], [6.0, 80.01], [6.01, 80.01]]}],
  "shoreline": [{"kind": "quay", "name": "Long quay", "points": [[6.0, 80.0], [6.0, 80.002]]}],
  "depths": [
    {"southWest": {"north_m": 0, "east_m": 0}, "spacing_m": 10, "rows": 2, "columns": 2, "unit": 0.1,
     "values": [50, 60, 70, 80]},
    {"southWest": {"north_m": -100, "east_m": -100}, "spacing_m": 100, "rows": 3, "columns": 3, "unit": 1,
     "values": [20, 20, 20, 20, 20, 20, 20, 20, 30]}],
  "shelter": [
    {"southWest": {"north_m": 0, "east_m": 0}, "spacing_m": 10, "rows": 2, "columns": 2, "unit": 0.01,
     "values": [10, 10, 10, 10]},
    {"southWest": {"north_m": -100, "east_m": -100}, "spacing_m": 100, "rows": 3, "columns": 3, "unit": 0.01,
     "values": [100, 100, 100, 100, 100, 100, 100, 100, 100]}],
  "berths": [
    {"id": "long-quay", "name": "Long quay", "face": [[6.0, 80.002], [6.0, 80.0]], "depth_m": 8,
     "bollards": [{"id": "b-1", "at": {"lat": 6.0, "lon": 80.001}}],
     "fenders": [{"at": {"lat": 6.0, "lon": 80.001}, "thickness_m": 0.9, "width_m": 1.2, "stiffness_kNpm": 250}]}],
  "marks": [
    {"id": "buoy-1", "name": "No. 1", "kind": "lateral-starboard", "at": {"lat": 6.001, "lon": 80.0}, "floating": true,
     "light": {"character": "Fl G 3s", "height_m": 4, "range_M": 3}}],
  "places": [{"id": "middle", "name": "Middle", "kind": "anchorage", "at": {"lat": 6.0, "lon": 80.0}}]
})";

std::string with(const std::string& from, const std::string& to, std::string text = kPond) {
    const std::size_t place = text.find(from);
    if (place == std::string::npos) throw std::logic_error("the pond has no " + from);
    return text.replace(place, from.size(), to);
}

std::string problemsOf(const std::string& text) {
    const auto loaded = loadArea("pond.json", text);
    return loaded ? "" : loaded.error().text();
}

Area pond() {
    auto loaded = loadArea("pond.json", kPond);
    if (!loaded) throw std::runtime_error(loaded.error().text());
    return std::move(loaded).value();
}

TEST(Area, AGoodDocumentIsRead) {
    const Area a = pond();
    EXPECT_EQ(a.id, "pond");
    EXPECT_EQ(a.utcOffset_min, 330);
    EXPECT_EQ(a.tide.size(), 1u);
    EXPECT_EQ(a.shore.lines().at(0).kind, ShoreKind::Quay);
    ASSERT_NE(a.findBollard("b-1"), nullptr);
    EXPECT_EQ(a.findBollard("b-2"), nullptr);
    EXPECT_EQ(a.findBerth("long-quay")->fenders.at(0).stiffness_Npm, 250e3);
    EXPECT_EQ(a.marks.at(0).light->character, "Fl G 3s");
    EXPECT_NEAR(length(a.findPlace("middle")->position), 0.0, 1e-6);
}

TEST(Area, LandRingsRunClockwiseWhateverTheSource) {
    const Area a = pond();
    EXPECT_GT(clockwiseArea_m2(a.land.at(0)), 0.0);
    EXPECT_TRUE(a.isLand(a.frame.toLocal({6.009, 80.008})));
    EXPECT_FALSE(a.isLand(a.frame.toLocal({6.001, 80.001})));
}

TEST(Area, TheWaterIsOnTheRightFromAToB) {
    const Berth berth = pond().berths.at(0);  // runs west, so the water is to the north
    EXPECT_NEAR(berth.along().east_m, -1.0, 1e-6);
    EXPECT_NEAR(berth.outward().north_m, 1.0, 1e-6);
    EXPECT_NEAR(berth.outward().east_m, 0.0, 1e-4);
}

TEST(Area, TheFineGridIsPreferred) {
    const Area a = pond();
    EXPECT_NEAR(a.depth_m({0.0, 0.0}), 5.0, 1e-6);
    EXPECT_NEAR(a.depth_m({5.0, 5.0}), 6.5, 1e-6);  // mean of the four
    EXPECT_NEAR(a.depth_m({10.0, 10.0}), 8.0, 1e-6);
    EXPECT_NEAR(a.depth_m({10.1, 10.0}), 20.1, 0.1);  // the coarse one takes over
    EXPECT_NEAR(a.depth_m({-50.0, -50.0}), 20.0, 1e-6);
    EXPECT_NEAR(a.depth_m({5000.0, 5000.0}), 30.0, 1e-6);  // its edge goes on
    EXPECT_NEAR(a.shelterFactor({5.0, 5.0}), 0.1, 1e-6);
    EXPECT_NEAR(a.shelterFactor({50.0, 50.0}), 1.0, 1e-6);
}

TEST(Area, WithoutShelterGridsTheSeaIsOpen) {
    const std::size_t begin = kPond.find("  \"shelter\""), end = kPond.find("  \"berths\"");
    const auto area = loadArea("pond.json", kPond.substr(0, begin) + kPond.substr(end));
    ASSERT_TRUE(area) << area.error().text();
    EXPECT_EQ(area->shelterFactor({5.0, 5.0}), 1.0);
}

TEST(Area, EveryProblemIsReportedAtOnceWithItsPath) {
    std::string text = with("\"id\": \"pond\"", "\"id\": \"The Pond\"");
    text = with("\"ialaRegion\": \"A\"", "\"ialaRegion\": \"C\"", text);
    text = with("\"waveDepth_m\": 20", "\"waveDepth_m\": \"deep\"", text);
    text = with("\"name\": \"M2\"", "\"name\": \"M22\"", text);
    text = with("[6.01, 80.01]]", "[96.01, 80.01]]", text);
    text = with("\"kind\": \"quay\"", "\"kind\": \"kwai\"", text);
    text = with("\"notice\"", "\"notize\"", text);
    const std::string problems = problemsOf(text);
    for (const char* expected :
         {"pond.json: id is \"The Pond\", expected 1 to 60 letters a-z, digits and hyphens",
          "pond.json: notice is missing, expected a text",
          "pond.json: ialaRegion is \"C\", expected one of A, B",
          "pond.json: waveDepth_m is \"deep\", expected 1 to 12000 m",
          "pond.json: tide.constituents[0].name is \"M22\", expected one of SA, SSA,",
          "pond.json: land[0].points[2] is a list of 2, expected [latitude, longitude] in degrees",
          "pond.json: shoreline[0].kind is \"kwai\", expected one of quay, jetty, breakwater, rock, beach, "
          "other",
          "pond.json: notize is unknown, expected one of"}) {
        EXPECT_NE(problems.find(expected), std::string::npos) << expected << "\nnot in\n" << problems;
    }
    EXPECT_EQ(std::count(problems.begin(), problems.end(), '\n'), 7);
}

TEST(Area, UnknownKeysAreRefusedInEveryPart) {
    const struct {
        const char* from;
        const char* to;
        const char* path;
    } cases[] = {{"\"source\": \"a book\"", "\"source\": \"a book\", \"x\": 1", "tide.x"},
                 {"\"amplitude_m\": 0.2", "\"amplitude_m\": 0.2, \"x\": 1", "tide.constituents[0].x"},
                 {"{\"points\"", "{\"x\": 1, \"points\"", "land[0].x"},
                 {"\"name\": \"Long quay\", \"points\"", "\"x\": 1, \"points\"", "shoreline[0].x"},
                 {"\"spacing_m\": 10,", "\"spacing_m\": 10, \"x\": 1,", "depths[0].x"},
                 {"\"depth_m\": 8,", "\"depth_m\": 8, \"x\": 1,", "berths[0].x"},
                 {"\"id\": \"b-1\",", "\"id\": \"b-1\", \"x\": 1,", "berths[0].bollards[0].x"},
                 {"\"thickness_m\": 0.9,", "\"thickness_m\": 0.9, \"x\": 1,", "berths[0].fenders[0].x"},
                 {"\"floating\": true,", "\"floating\": true, \"x\": 1,", "marks[0].x"},
                 {"\"height_m\": 4,", "\"height_m\": 4, \"x\": 1,", "marks[0].light.x"},
                 {"\"kind\": \"anchorage\",", "\"kind\": \"anchorage\", \"x\": 1,", "places[0].x"}};
    for (const auto& c : cases) {
        EXPECT_EQ(
            problemsOf(with(c.from, c.to)).rfind(std::string("pond.json: ") + c.path + " is unknown", 0), 0u)
            << c.path << ": " << problemsOf(with(c.from, c.to));
    }
}

TEST(Area, NotANumberIsRefused) {
    EXPECT_NE(problemsOf(with("[50, 60, 70, 80]", "[50, NaN, 70, 80]")).find("is not JSON"),
              std::string::npos);
    EXPECT_EQ(problemsOf(with("[50, 60, 70, 80]", "[50, null, 70, 80]")),
              "pond.json: depths[0].values[1] is null, expected -5000 to 120000 units");
    EXPECT_NE(problemsOf(with("\"waveDepth_m\": 20", "\"waveDepth_m\": 1e999")), "");
}

TEST(Area, ValuesOutOfRangeAreRefused) {
    EXPECT_EQ(problemsOf(with("[10, 10, 10, 10]", "[10, 101, 10, -1]")),
              "pond.json: shelter[0].values[1] is 101, expected 0 to 100 units\n"
              "pond.json: shelter[0].values[3] is -1, expected 0 to 100 units");
}

TEST(Area, GridsMustHoldAsManyValuesAsTheySay) {
    EXPECT_EQ(problemsOf(with("[50, 60, 70, 80]", "[50, 60, 70]"))
                  .find("pond.json: depths[0].values is a list of 3, "
                        "expected a list of 4 numbers"),
              0u);
    EXPECT_NE(problemsOf(with("\"rows\": 2", "\"rows\": 1")), "");
    EXPECT_NE(problemsOf(with("\"rows\": 2", "\"rows\": 2.5")), "");
    EXPECT_NE(problemsOf(with("\"spacing_m\": 10", "\"spacing_m\": 0")), "");
    EXPECT_NE(problemsOf(with("\"rows\": 2, \"columns\": 2", "\"rows\": 100000000, \"columns\": 100000000")),
              "");
}

TEST(Area, IdsAreUniqueAcrossTheDocument) {
    EXPECT_EQ(problemsOf(with("\"id\": \"buoy-1\"", "\"id\": \"b-1\"")),
              "pond.json: marks[0].id is \"b-1\" again, expected each id once");
    EXPECT_EQ(problemsOf(with("\"id\": \"middle\"", "\"id\": \"long-quay\"")),
              "pond.json: places[0].id is \"long-quay\" again, expected each id once");
}

TEST(Area, ABerthNeedsAStraightFace) {
    EXPECT_EQ(problemsOf(with("[[6.0, 80.002], [6.0, 80.0]]", "[[6.0, 80.0], [6.0, 80.0]]")),
              "pond.json: berths[0].face is not a straight line, expected two points at least 1 m apart");
    EXPECT_NE(problemsOf(with("[[6.0, 80.002], [6.0, 80.0]]", "[[6.0, 80.002], [6.0, 80.001], [6.0, 80.0]]")),
              "");
}

TEST(Area, AnyTruncationIsRefusedAndNoneCrashes) {
    for (std::size_t length = 0; length < kPond.size() - 1; length += 7) {
        EXPECT_NE(problemsOf(kPond.substr(0, length)), "") << length;
    }
}

TEST(Shore, TheIndexFindsTheNearestLineAsBruteForceDoes) {
    const auto loaded = loadArea("galle", test::readAsset("areas/galle/area.json"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    const auto bruteForce_m = [&](NorthEast p, double limit_m) {
        double best_m = limit_m;
        for (const ShoreLine& line : loaded->shore.lines()) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                best_m = std::min(best_m, distanceTo({line.points[i - 1], line.points[i]}, p));
            }
        }
        return best_m;
    };
    Random random(214);
    for (int i = 0; i < 2000; ++i) {  // also beyond the index
        const NorthEast p{random.uniform() * 12e3 - 6e3, random.uniform() * 12e3 - 6e3};
        const double limit_m = 10.0 + 3000.0 * random.uniform();
        EXPECT_EQ(loaded->shore.distance_m(p, limit_m), bruteForce_m(p, limit_m))
            << p.north_m << ' ' << p.east_m;
    }
}

}  // namespace
}  // namespace sagara::core
