#include "core/world/Streams.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

const Utc kStart = *parseUtc("2027-01-15T03:30:00Z");
const TidePrediction kTide(1.0, {{"M2", 0.5, 0.4}, {"S2", 0.2, 1.0}}, kStart);

Streams read(const std::string& text) {
    config::Document document("streams", text);
    config::Reader in(document.root());
    Streams s = readStreams(in, LocalFrame(GeoPoint{6.0, 80.0}));
    EXPECT_TRUE(document.problems().empty()) << document.problems().text();
    return s;
}

Streams::Table table(NorthEast at, double springs_mps, double neaps_mps) {
    Streams::Table t;
    t.at = at;
    for (std::size_t i = 0; i < 13; ++i) {
        const double phase = std::sin((static_cast<double>(i) - 6.0) * kPi / 6.2);
        t.springs_mps[i] = {springs_mps * phase, 0.0};
        t.neaps_mps[i] = {neaps_mps * phase, 0.0};
    }
    return t;
}

TEST(Streams, HighWatersAreTheTopsOfTheTide) {
    const auto all = highWatersOf(kTide, 12 * 3600.0);
    ASSERT_GE(all.size(), 5u);
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const auto height = [&](double t) {
            return kTide.height_m(SimTime{static_cast<std::int64_t>(t * 1e6)});
        };
        EXPECT_GE(height(all[i].time_s), height(all[i].time_s - 120.0));
        EXPECT_GE(height(all[i].time_s), height(all[i].time_s + 120.0));
        EXPECT_NEAR((all[i + 1].time_s - all[i].time_s) / 3600.0, 12.4, 0.4);
        EXPECT_GT(all[i].range_m, 0.5);  // between neaps, 2 (0.5 - 0.2), and springs, 2 (0.5 + 0.2)
        EXPECT_LT(all[i].range_m, 1.45);
    }
}

TEST(Streams, GoByTheHourAndTheRangeOfTheTide) {
    Streams s;
    s.tables = {table({}, 2.0, 1.0)};
    s.springRange_m = 1.4;
    s.neapRange_m = 0.6;
    EXPECT_NEAR(s.at({}, {0.0, -12.4, 1.4}).north_m, 0.0, 1e-12);
    EXPECT_NEAR(s.at({}, {3.0, -9.4, 1.4}).north_m, 2.0 * std::sin(3 * kPi / 6.2), 1e-12);
    EXPECT_NEAR(s.at({}, {3.0, -9.4, 0.6}).north_m, 1.0 * std::sin(3 * kPi / 6.2), 1e-12);
    EXPECT_NEAR(s.at({}, {3.0, -9.4, 1.0}).north_m, 1.5 * std::sin(3 * kPi / 6.2), 1e-12);
    EXPECT_NEAR(s.at({}, {9.4, -3.0, 1.4}).north_m, -2.0 * std::sin(3 * kPi / 6.2), 1e-12);
}

TEST(Streams, ChangeWithoutAJumpThroughTheTide) {
    Streams s;
    s.tables = {table({}, 2.0, 1.0)};
    s.springRange_m = 1.4;
    s.neapRange_m = 0.6;
    s.highWater_s = 1500.0;
    const auto highWaters = highWatersOf(kTide, 48 * 3600.0);
    NorthEast before = s.at({}, tidalClockAt(highWaters, {}));
    for (std::int64_t t = 60; t < 48 * 3600; t += 60) {
        const NorthEast now = s.at({}, tidalClockAt(highWaters, SimTime::fromSeconds(t)));
        EXPECT_LT(length(now - before), 0.15) << t;  // a new range at high water changes it by a tenth
        before = now;
    }
}

TEST(Streams, NearATableItsOwnRateHolds) {
    Streams s;
    s.tables = {table({0.0, 0.0}, 2.0, 2.0), table({1000.0, 0.0}, 1.0, 1.0)};
    s.springRange_m = 1.0;
    const TidalClock clock{3.0, -9.4, 1.0};
    const double unit = std::sin(3 * kPi / 6.2);
    EXPECT_NEAR(s.at({0.0, 0.0}, clock).north_m / unit, 2.0, 1e-4);
    EXPECT_NEAR(s.at({1000.0, 0.0}, clock).north_m / unit, 1.0, 1e-4);
    EXPECT_NEAR(s.at({500.0, 0.0}, clock).north_m / unit, 1.5, 1e-9);
}

TEST(Streams, FieldIsReadInterpolatedAndEndsAtItsEdge) {
    const Streams s = read(R"({"source": "test", "fields": [{"southWest": {"north_m": 0, "east_m": 0},
        "spacing_m": 100, "rows": 2, "columns": 2, "unit": 0.01, "north": [0, 0, 100, 100], "east": [50, 50, 50, 50]}]})");
    EXPECT_FALSE(s.isTidal());
    const NorthEast middle = s.at({50.0, 50.0}, {});
    EXPECT_NEAR(middle.north_m, 0.5, 1e-6);
    EXPECT_NEAR(middle.east_m, 0.5, 1e-6);
    EXPECT_EQ(length(s.at({150.0, 50.0}, {})), 0.0);
}

TEST(Streams, ADocumentIsReadInKnotsAndDegreesAndItsMistakesNamed) {
    const std::string hours = "[90,90,90,90,90,90,90,90,90,90,90,90,90]",
                      rates = "[1,1,1,1,1,1,1,1,1,1,1,1,1]";
    const std::string good = R"({"to_deg": )" + hours + R"(, "rate_kn": )" + rates + "}";
    const std::string begin =
        R"({"source": "test", "springRange_m": 1, "neapRange_m": 0.4, "tables": [{"at": {"lat": 6, "lon": 80}, "springs": )";
    const Streams s = read(begin + good + R"(, "neaps": )" + good + "}]}");
    EXPECT_NEAR(s.at({}, {1.0, -11.4, 0.7}).east_m, kKnot_mps, 1e-9);

    config::Document document("streams",
                              begin + good + R"(, "neaps": {"to_deg": [1], "rate_kn": )" + rates + "}}]}");
    config::Reader in(document.root());
    (void)readStreams(in, LocalFrame(GeoPoint{6.0, 80.0}));
    EXPECT_EQ(document.problems().size(), 1u) << document.problems().text();
}

}  // namespace
}  // namespace sagara::core
