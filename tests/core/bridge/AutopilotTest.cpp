#include "core/bridge/Autopilot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "BridgeShip.h"
#include "core/base/Angle.h"

namespace sagara::core {
namespace {

using test::BridgeShip;

constexpr double kLessonRadius_m = 0.075 * kNauticalMile_m, kLessonCorridor_m = 0.02 * kNauticalMile_m;

double degrees(double angle_rad) { return angle_rad / kDegree_rad; }

// --- the rudder it orders ---

class HeadingRudder : public ::testing::Test {
protected:
    const OwnShip& ship = test::shippedShip("patrol51");
    ShipMotion m{.surge_mps = 5.0};
    double rudder_deg(double heading_deg) {
        return degrees(steerHeading_rad(ship, m, heading_deg * kDegree_rad, 0.0));
    }
};

TEST_F(HeadingRudder, IsAmidshipsOnTheHeading) {
    m.heading_rad = 2.0;
    EXPECT_EQ(steerHeading_rad(ship, m, 2.0, 0.0), 0.0);
}

TEST_F(HeadingRudder, IsTowardsTheHeadingTheShortWayRound) {
    m.heading_rad = 350.0 * kDegree_rad;
    EXPECT_GT(rudder_deg(10.0), 0.0);
    EXPECT_LT(rudder_deg(340.0), 0.0);
    m.heading_rad = (720.0 + 10.0) * kDegree_rad;  // headings are not wrapped
    EXPECT_LT(rudder_deg(350.0), 0.0);
    EXPECT_NEAR(rudder_deg(10.0), 0.0, 1e-9);
}

TEST_F(HeadingRudder, ChecksTheSwingWhenSheIsThere) {
    m.yawRate_radps = 0.02;
    EXPECT_LT(rudder_deg(0.0), 0.0);
    m.yawRate_radps = -0.02;
    EXPECT_GT(rudder_deg(0.0), 0.0);
}

TEST_F(HeadingRudder, IsNeverBeyondTheLimit) {
    m.yawRate_radps = -1.0;
    EXPECT_DOUBLE_EQ(rudder_deg(170.0), degrees(ship.vessel.steering.limit_rad));
    m.yawRate_radps = 1.0;
    EXPECT_DOUBLE_EQ(rudder_deg(-170.0), -degrees(ship.vessel.steering.limit_rad));
}

TEST_F(HeadingRudder, StaysFiniteForAShipWithoutWay) {
    m.surge_mps = 0.0;
    m.yawRate_radps = 0.1;
    EXPECT_TRUE(std::isfinite(rudder_deg(90.0)));
}

TEST(AutopilotOff, LeavesTheWheelToTheHand) {
    BridgeShip s("patrol51", TelegraphStep::HalfAhead);
    AutopilotState off;
    EXPECT_EQ(steerAutopilot_rad(s.ship, s.path, s.motion(), off, 0.123, kTick_s), 0.123);
}

TEST(AutopilotTrack, WithoutARouteLeavesTheWheelToTheHand) {
    BridgeShip s("patrol51", TelegraphStep::HalfAhead);
    AutopilotState track;
    track.mode = AutopilotMode::Track;
    EXPECT_EQ(steerAutopilot_rad(s.ship, RoutePath(), s.motion(), track, 0.123, kTick_s), 0.123);
}

// --- ships steered by it ---

struct Change {
    const char* vessel;
    TelegraphStep step;
    double from_deg, to_deg, turn_deg;
    double settles_lengths;  ///< distance run by then over the ship's length
};
void PrintTo(const Change& c, std::ostream* out) { *out << c.vessel << " to " << c.to_deg; }
std::vector<Change> changes() {
    std::vector<Change> all;
    for (const char* vessel : {"patrol51", "esso-osaka"}) {
        for (const TelegraphStep step :
             {TelegraphStep::SlowAhead, TelegraphStep::HalfAhead, TelegraphStep::FullAhead}) {
            for (const auto& [from_deg, to_deg, turn_deg] : {std::tuple{0.0, 10.0, 10.0},
                                                             {0.0, 60.0, 60.0},
                                                             {350.0, 20.0, 30.0},
                                                             {20.0, 350.0, -30.0},
                                                             {90.0, 300.0, -150.0}}) {
                all.push_back({vessel, step, from_deg, to_deg, turn_deg, 20.0});
            }
        }
    }
    return all;
}
class HeadingMode : public ::testing::TestWithParam<Change> {};

TEST_P(HeadingMode, TurnsTheShortWayAndSettlesWithoutMuchOvershoot) {
    const Change& c = GetParam();
    BridgeShip s(c.vessel, c.step);
    s.motion().heading_rad = c.from_deg * kDegree_rad;
    s.order(AutopilotOrder{AutopilotMode::Heading, c.to_deg * kDegree_rad});
    const double way = std::copysign(1.0, c.turn_deg), began_rad = s.motion().heading_rad;
    const double length_m = s.ship.vessel.hull.lengthBp_m;
    double most_deg = 0.0, least_deg = 0.0;
    const auto watch = [&] {
        const double turned_deg = way * degrees(s.motion().heading_rad - began_rad);
        most_deg = std::max(most_deg, turned_deg);
        least_deg = std::min(least_deg, turned_deg);
    };
    s.run(c.settles_lengths * length_m / s.motion().surge_mps, watch);
    EXPECT_NEAR(degrees(wrapPi(s.motion().heading_rad - c.to_deg * kDegree_rad)), 0.0, 1.0);
    EXPECT_GT(least_deg, -0.5);
    // a tenth of the turn, as a trainer would still call it steady, and never less than a degree
    EXPECT_LT(most_deg, std::abs(c.turn_deg) + std::max(1.0, 0.1 * std::abs(c.turn_deg)));
    s.run(600.0, [&] {  // and stays
        ASSERT_NEAR(degrees(wrapPi(s.motion().heading_rad - c.to_deg * kDegree_rad)), 0.0, 1.0);
    });
}
INSTANTIATE_TEST_SUITE_P(Changes, HeadingMode, ::testing::ValuesIn(changes()), [](const auto& row) {
    std::string name = row.param.vessel + std::string("At") +
                       std::to_string(static_cast<int>(row.param.step)) + "From" +
                       std::to_string(std::lround(row.param.from_deg)) + "To" +
                       std::to_string(std::lround(row.param.to_deg));
    std::erase(name, '-');
    return name;
});

TEST(HeadingModeMirrored, TurnsAlikeToBothSides) {
    BridgeShip a("patrol51", TelegraphStep::HalfAhead), b("patrol51", TelegraphStep::HalfAhead);
    a.order(AutopilotOrder{AutopilotMode::Heading, 0.7});
    b.order(AutopilotOrder{AutopilotMode::Heading, -0.7});
    for (int i = 0; i < 120 * kTicksPerSecond; ++i) {
        a.tick();
        b.tick();
        ASSERT_NEAR(a.motion().heading_rad, -b.motion().heading_rad, 1e-9);
        ASSERT_NEAR(a.motion().east_m, -b.motion().east_m, 1e-6);
    }
}

// --- on a track ---

class TrackMode : public ::testing::Test {
protected:
    static double offTrack_m(const BridgeShip& s) {
        return s.path.nearest(s.motion().position(), s.state.autopilot.along_m, 100.0, 100.0).offTrack_m;
    }
};

struct Beside {
    const char* vessel;
    TelegraphStep step;
    double off_lengths;
};
void PrintTo(const Beside& c, std::ostream* out) { *out << c.vessel << ", " << c.off_lengths << " L off"; }
class TrackModeFromTheSide : public TrackMode, public ::testing::WithParamInterface<Beside> {};

TEST_P(TrackModeFromTheSide, ComesOntoTheTrackAndStays) {
    const Beside& c = GetParam();
    BridgeShip s(c.vessel, c.step);
    const double length_m = s.ship.vessel.hull.lengthBp_m;
    s.path = test::pathOf({{0.0, 0.0}, {300.0 * length_m, 0.0}}, 0.0);
    const double off_m = c.off_lengths * length_m;
    s.motion().east_m = off_m;
    s.order(AutopilotOrder{AutopilotMode::Track, 0.0});
    double farthest_m = 0.0, over_m = 0.0;
    s.run(20.0 * length_m / s.motion().surge_mps, [&] {
        farthest_m = std::max(farthest_m, std::abs(offTrack_m(s)));
        over_m = std::max(over_m, -offTrack_m(s) * std::copysign(1.0, off_m));
    });
    EXPECT_LE(farthest_m, std::abs(off_m) + 0.1 * length_m);  // the stern kicks out first
    // Not farther on the other side than the harbour corridor is wide for patrol51, in lengths.
    EXPECT_LT(over_m, kLessonCorridor_m / 51.5 * length_m);
    s.run(40.0 * length_m / s.motion().surge_mps);
    EXPECT_LT(std::abs(offTrack_m(s)), 0.05 * length_m);
    EXPECT_NEAR(degrees(wrapPi(s.motion().heading_rad)), 0.0, 1.0);
}
INSTANTIATE_TEST_SUITE_P(Tracks, TrackModeFromTheSide,
                         ::testing::Values(Beside{"patrol51", TelegraphStep::SlowAhead, 1.0},
                                           Beside{"patrol51", TelegraphStep::HalfAhead, -1.0},
                                           Beside{"patrol51", TelegraphStep::FullAhead, 1.0},
                                           Beside{"patrol51", TelegraphStep::HalfAhead, 4.0},
                                           Beside{"esso-osaka", TelegraphStep::SlowAhead, 1.0},
                                           Beside{"esso-osaka", TelegraphStep::HalfAhead, -1.0},
                                           Beside{"esso-osaka", TelegraphStep::FullAhead, 4.0}),
                         [](const auto& row) {
                             const std::string ship =
                                 row.param.vessel == std::string("patrol51") ? "patrol51" : "essoOsaka";
                             return ship + std::to_string(row.index);
                         });

class TrackModeInACurrent : public TrackMode, public ::testing::WithParamInterface<double> {};
TEST_P(TrackModeInACurrent, HeadsUpIntoItAndStaysOnTheTrack) {
    BridgeShip s("patrol51", TelegraphStep::SlowAhead);
    s.path = test::pathOf({{0.0, 0.0}, {20'000.0, 0.0}}, 0.0);
    s.current = {0.0, GetParam()};
    s.order(AutopilotOrder{AutopilotMode::Track, 0.0});
    double farthest_m = 0.0;
    s.run(900.0, [&] { farthest_m = std::max(farthest_m, std::abs(offTrack_m(s))); });
    EXPECT_LT(farthest_m, kLessonCorridor_m);
    EXPECT_LT(std::abs(offTrack_m(s)), 2.0);
    EXPECT_NEAR(degrees(s.motion().heading_rad), degrees(-std::asin(GetParam() / s.motion().surge_mps)), 0.5);
}
INSTANTIATE_TEST_SUITE_P(FromTheSide, TrackModeInACurrent, ::testing::Values(0.25, -0.5, 1.0));

struct Turn {
    TelegraphStep step;
    double turn_deg;
};
class TrackModeTurn : public TrackMode, public ::testing::WithParamInterface<Turn> {};

TEST_P(TrackModeTurn, HoldsTheArcWithinTheHarboursCorridor) {
    BridgeShip s("patrol51", GetParam().step);
    const NorthEast corner{1000.0, 0.0};
    s.path =
        test::pathOf({{0.0, 0.0}, corner, corner + 1000.0 * unitVector(GetParam().turn_deg * kDegree_rad)},
                     kLessonRadius_m);
    s.order(AutopilotOrder{AutopilotMode::Track, 0.0});
    double farthest_m = 0.0;
    while (s.state.autopilot.along_m < s.path.length_m() - 50.0) {
        s.tick();
        farthest_m = std::max(farthest_m, std::abs(offTrack_m(s)));
        ASSERT_LT(s.time_s, 3600.0);
    }
    EXPECT_LT(farthest_m, kLessonCorridor_m);
    EXPECT_LT(std::abs(offTrack_m(s)), 3.0);
    EXPECT_NEAR(degrees(wrapPi(s.motion().heading_rad - GetParam().turn_deg * kDegree_rad)), 0.0, 2.0);
}
INSTANTIATE_TEST_SUITE_P(Turns, TrackModeTurn,
                         ::testing::Values(Turn{TelegraphStep::DeadSlowAhead, 45.0},
                                           Turn{TelegraphStep::SlowAhead, 90.0},
                                           Turn{TelegraphStep::SlowAhead, -90.0},
                                           Turn{TelegraphStep::HalfAhead, 60.0},
                                           Turn{TelegraphStep::HalfAhead, -120.0}));

TEST_F(TrackMode, TakesUpTheTrackWhereTheShipIs) {
    // The lesson's way: first away from where she has been sailed to by hand, then back past it.
    BridgeShip s("patrol51", TelegraphStep::HalfAhead);
    s.path = test::pathOf({{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 1000.0}, {-4000.0, 1000.0}}, 200.0);
    s.motion().north_m = -1000.0;
    s.motion().east_m = 980.0;
    s.motion().heading_rad = kPi;
    s.order(AutopilotOrder{AutopilotMode::Track, 0.0});
    s.run(120.0, [&] { ASSERT_NEAR(degrees(s.motion().heading_rad), 180.0, 30.0); });
    EXPECT_LT(s.motion().north_m, -1500.0);
    EXPECT_NEAR(offTrack_m(s), 0.0, 4.0);  // a fifth of what it was
}

TEST_F(TrackMode, OrderedAgainAfterAPassageByHandGoesOnFromThere) {
    BridgeShip s("patrol51", TelegraphStep::HalfAhead);
    s.path = test::pathOf({{0.0, 0.0}, {10'000.0, 0.0}}, 0.0);
    s.order(AutopilotOrder{AutopilotMode::Track, 0.0});
    s.run(30.0);
    s.order(AutopilotOrder{AutopilotMode::Heading, 0.0});
    s.run(300.0);  // well over 300 m
    ASSERT_GT(s.motion().north_m, 1500.0);
    s.order(AutopilotOrder{AutopilotMode::Track, 0.0});
    s.run(60.0, [&] { ASSERT_NEAR(degrees(s.motion().heading_rad), 0.0, 10.0); });
    EXPECT_NEAR(s.state.autopilot.along_m, s.motion().north_m, 1.0);
}

}  // namespace
}  // namespace sagara::core
