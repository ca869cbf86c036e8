#include "core/base/Config.h"

#include <gtest/gtest.h>

namespace sagara::core::config {
namespace {

struct Sample {
    double length_m = 0.0;
    int decks = 0;
    std::string name;
    enum class Kind { Tug, Ferry } kind = Kind::Tug;
};

Result<Sample, Problems> loadSample(std::string_view text) {
    Document document("ship.json", text);
    Reader in(document.root());
    Sample s;
    s.length_m = in.number("length_m", {1.0, 500.0, "m"});
    s.decks = in.integerOr("decks", 1, 1, 20);
    s.name = in.text("name");
    s.kind = in.choice<Sample::Kind>("kind", {{"tug", Sample::Kind::Tug}, {"ferry", Sample::Kind::Ferry}});
    in.rejectUnknownKeys();
    return document.finish(s);
}

std::string problemsOf(std::string_view text) {
    const auto loaded = loadSample(text);
    return loaded ? "" : loaded.error().text();
}

TEST(Config, AGoodDocumentIsRead) {
    const auto s = loadSample(R"({"length_m": 51.5, "decks": 3, "name": "Sayura", "kind": "ferry"})");
    ASSERT_TRUE(s);
    EXPECT_EQ(s->length_m, 51.5);
    EXPECT_EQ(s->decks, 3);
    EXPECT_EQ(s->kind, Sample::Kind::Ferry);
}

TEST(Config, EveryProblemIsReportedAtOnceWithItsPath) {
    EXPECT_EQ(problemsOf(R"({"length_m": -107.3, "decks": 1.5, "kind": "raft", "lenght_m": 3})"),
              "ship.json: length_m is -107.3, expected 1 to 500 m\n"
              "ship.json: decks is 1.5, expected a whole number from 1 to 20\n"
              "ship.json: name is missing, expected a text\n"
              "ship.json: kind is \"raft\", expected one of tug, ferry\n"
              "ship.json: lenght_m is unknown, expected one of decks, kind, length_m, name");
}

TEST(Config, NotANumberIsRefused) {
    EXPECT_EQ(problemsOf(R"({"length_m": "long", "name": "a", "kind": "tug"})"),
              "ship.json: length_m is \"long\", expected 1 to 500 m");
    EXPECT_NE(problemsOf(R"({"length_m": NaN, "name": "a", "kind": "tug"})").find("is not JSON"),
              std::string::npos);
    EXPECT_NE(problemsOf(R"({"length_m": 1e999, "name": "a", "kind": "tug"})"), "");
    EXPECT_EQ(problemsOf(R"({"length_m": null, "name": "a", "kind": "tug"})"),
              "ship.json: length_m is null, expected 1 to 500 m");
}

TEST(Config, MalformedTextSaysWhere) {
    EXPECT_NE(problemsOf("{\n \"name\": ").find("ship.json: is not JSON (parse error at line 2, column"),
              std::string::npos);
    EXPECT_EQ(problemsOf("[1]"), "ship.json: is a list of 1, expected a JSON object");
    EXPECT_NE(problemsOf(""), "");
}

TEST(Config, NestedPathsNameTheItem) {
    Document document("a.json",
                      R"({"list": [{"x": 1}, {"x": "no"}], "points": [[1, 2], [91, 0]], "at": {"lat": 1}})");
    Reader in(document.root());
    for (const Node& node : in.list("list")) Reader(node).number("x", {0.0, 5.0, "m"});
    in.geoPoints("points", 3);
    in.geoPoint("at");
    EXPECT_EQ(document.problems().text(),
              "a.json: list[1].x is \"no\", expected 0 to 5 m\n"
              "a.json: points[1] is a list of 2, expected [latitude, longitude] in degrees\n"
              "a.json: points has 2 points, expected at least 3\n"
              "a.json: at.lon is missing, expected -180 to 180 deg");
}

TEST(Config, AKeyMayLeadIntoWhatItNames) {
    Document document("test.json", R"({"to": {"lat": 6.5, "lon": 80}, "between": ["a", {"lat": 95}]})");
    Reader in(document.root());
    EXPECT_TRUE(in.has("to.lat"));
    EXPECT_FALSE(in.has("to.name"));
    EXPECT_FALSE(in.has("between[0].lat"));
    EXPECT_TRUE(in.has("between[1].lat"));
    EXPECT_FALSE(in.has("between[2]"));
    EXPECT_EQ(in.text("between[0]"), "a");
    EXPECT_EQ(in.number("to.lat", {-90.0, 90.0, "deg"}), 6.5);
    (void)in.number("between[1].lat", {-90.0, 90.0, "deg"});
    in.rejectUnknownKeys();
    EXPECT_EQ(document.problems().text(), "test.json: between[1].lat is 95, expected -90 to 90 deg");
}

TEST(Config, KindAndVersionAreChecked) {
    Document wrong("a.json", R"({"document": "area", "version": 9})");
    EXPECT_FALSE(wrong.isKind("vessel", 2));
    EXPECT_EQ(wrong.problems().text(),
              "a.json: document is \"area\", expected \"vessel\"\n"
              "a.json: version is 9, expected a whole number from 1 to 2");
    Document right("a.json", R"({"document": "vessel", "version": 2})");
    EXPECT_TRUE(right.isKind("vessel", 2));
    EXPECT_EQ(right.version(), 2);
}

TEST(Config, IdsAreShortAndPlain) {
    EXPECT_TRUE(isId("patrol51"));
    EXPECT_TRUE(isId("esso-osaka"));
    for (const char* bad : {"", "Patrol", "a b", "../x", "a/b"}) EXPECT_FALSE(isId(bad)) << bad;
}

}  // namespace
}  // namespace sagara::core::config
