#include "core/bridge/Pilot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "BridgeShip.h"
#include "core/base/Angle.h"
#include "core/base/Archive.h"

namespace sagara::core {
namespace {

using test::BridgeShip;

/// A patrol vessel whose pilot has the ship.
class Piloted : public ::testing::Test {
protected:
    BridgeShip s{"patrol51", TelegraphStep::Stop};
    void engage(PilotScript script) {
        s.script = std::move(script);
        s.order(PilotOrder{true});
    }
    bool done() const { return s.state.pilot.step >= s.script.size(); }
    double untilDone_s(double atMost_s) {
        const double began_s = s.time_s;
        while (!done() && s.time_s - began_s < atMost_s) s.tick();
        return s.time_s - began_s;
    }
    void makeWay(TelegraphStep step) { s.state = test::underWay(s.ship, step); }
};

TEST_F(Piloted, NotEngagedHeTouchesNothing) {
    s.script = {RunStep{0.3, {2.0, 2.0}, {}, {}, {}, 60.0}};
    const Bytes before = toBytes(s.state);
    runPilot(s.script, s.path, s.ship, s.state, kTick_s);
    EXPECT_EQ(toBytes(s.state), before);
}

TEST_F(Piloted, WithNothingLeftToDoHeTouchesNothing) {
    engage({});
    const Bytes before = toBytes(s.state);
    runPilot(s.script, s.path, s.ship, s.state, kTick_s);
    EXPECT_EQ(toBytes(s.state), before);
}

// --- run ---

TEST_F(Piloted, ARunHoldsRudderAndShaftsForItsTime) {
    engage({RunStep{0.3, {2.0, -1.0}, {}, {}, {}, 20.0}});
    s.run(10.0);
    EXPECT_EQ(s.state.steering.order_rad, 0.3);
    EXPECT_EQ(s.state.shafts[0].order_rps, 2.0);
    EXPECT_EQ(s.state.shafts[1].order_rps, -1.0);
    EXPECT_FALSE(done());
    EXPECT_NEAR(10.0 + untilDone_s(60.0), 20.0, 2 * kTick_s);
}

TEST_F(Piloted, ARunEndsWhenSheHasTurned) {
    for (const double rudder_rad : {0.3, -0.3}) {
        s.state = test::underWay(s.ship, TelegraphStep::HalfAhead);
        s.motion().heading_rad = 6.0;  // through north as well
        engage({RunStep{rudder_rad, {4.0, 4.0}, 30.0 * kDegree_rad, {}, {}, 600.0}});
        untilDone_s(700.0);
        EXPECT_NEAR(std::abs(s.motion().heading_rad - 6.0), 30.0 * kDegree_rad, 0.2 * kDegree_rad);
    }
}

TEST_F(Piloted, ARunEndsWhenSheHasMoved) {
    makeWay(TelegraphStep::HalfAhead);
    engage({RunStep{0.0, {4.0, 4.0}, {}, 100.0, {}, 600.0}});
    untilDone_s(700.0);
    EXPECT_NEAR(length(s.motion().position()), 100.0, 0.5);
}

TEST_F(Piloted, ARunEndsWhenSheIsSlowEnough) {
    makeWay(TelegraphStep::HalfAhead);
    engage({RunStep{0.0, {0.0, 0.0}, {}, {}, 2.0, 3600.0}});
    ASSERT_LT(untilDone_s(3600.0), 3500.0);
    EXPECT_NEAR(s.motion().surge_mps, 2.0, 0.01);
}

TEST_F(Piloted, OneStepFollowsTheOther) {
    engage({RunStep{0.1, {1.0, 1.0}, {}, {}, {}, 5.0}, RunStep{-0.1, {2.0, 2.0}, {}, {}, {}, 5.0}});
    s.run(4.9);
    EXPECT_EQ(s.state.pilot.step, 0u);
    s.run(0.3);
    EXPECT_EQ(s.state.pilot.step, 1u);
    EXPECT_EQ(s.state.steering.order_rad, -0.1);
    s.run(4.9);
    EXPECT_TRUE(done());
}

// --- lines ---

TEST(PilotLines, AreWorkedOnceAndWaitedFor) {
    OwnShip ship("own", "Own", test::shippedShip("patrol51").vessel);
    ship.lines.assign(4, {{24.0, -1.6}, {30.0, -10.0}});
    OwnShipState state = startOf(ship);
    const PilotScript script{LinesStep{0b0001, 0b0010, 0b0100, 0b1000, 3.0}};
    obey(ship, state, PilotOrder{true});
    runPilot(script, {}, ship, state, kTick_s);
    EXPECT_EQ(state.lines[0].status, LineStatus::CastOff);
    EXPECT_EQ(state.lines[1].status, LineStatus::Slacking);
    EXPECT_EQ(state.lines[2].status, LineStatus::Heaving);
    EXPECT_EQ(state.lines[3].status, LineStatus::Fast);
    obey(ship, state, LineOrder{1, LineAction::Hold});  // somebody else's order stands
    double waited_s = 0.0;
    for (; state.pilot.step == 0 && waited_s < 10.0; waited_s += kTick_s)
        runPilot(script, {}, ship, state, kTick_s);
    EXPECT_NEAR(waited_s, 3.0, 2 * kTick_s);
    EXPECT_EQ(state.lines[1].status, LineStatus::Fast);
}

// --- turn ---

class PilotTurns : public Piloted, public ::testing::WithParamInterface<double> {};
TEST_P(PilotTurns, OnTheSpotTheShortWayRound) {
    s.motion().heading_rad = 1.0;
    engage({TurnStep{1.0 + GetParam(), 170.0 * kRpm_rps}});
    double farthest_m = 0.0, wrongWay_rad = 0.0;
    const double way = std::copysign(1.0, GetParam());
    while (!done() && s.time_s < 600.0) {
        s.tick();
        farthest_m = std::max(farthest_m, length(s.motion().position()));
        wrongWay_rad = std::max(wrongWay_rad, -way * (s.motion().heading_rad - 1.0));
    }
    EXPECT_TRUE(done());
    EXPECT_NEAR(wrapPi(s.motion().heading_rad - 1.0 - GetParam()) / kDegree_rad, 0.0, 8.0);
    EXPECT_LT(farthest_m, s.ship.vessel.hull.lengthOverall_m);
    EXPECT_LT(wrongWay_rad, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Angles, PilotTurns, ::testing::Values(0.5, -0.5, 2.0, -2.0, 3.0));

// --- track ---

class PilotOnTrack : public Piloted {
protected:
    void SetUp() override {
        makeWay(TelegraphStep::SlowAhead);
        s.path = test::pathOf({{0.0, 0.0}, {8000.0, 0.0}}, 0.0);
    }
    /// 10 kn, 6 kn within 500 m of the place 3 km up the track.
    TrackStep zoned(double untilAlong_m) const {
        return {{{6.0 * kKnot_mps, true, 0, {3000.0, 0.0}, 500.0}}, 10.0 * kKnot_mps, untilAlong_m};
    }
    double offTrack_m() const { return std::abs(s.motion().east_m); }
};

TEST_F(PilotOnTrack, HeKeepsTheSpeedsOfTheZonesAndSlowsDownInTime) {
    engage({zoned(5000.0)});
    double fastest_mps = 0.0, fastestInside_mps = 0.0;
    s.run(3600.0, [&] {
        if (done()) return;
        fastest_mps = std::max(fastest_mps, s.alongGround_mps());
        if (std::abs(s.motion().north_m - 3000.0) < 500.0)
            fastestInside_mps = std::max(fastestInside_mps, s.alongGround_mps());
    });
    EXPECT_TRUE(done());
    // What the lesson's script leaves to its limits and the tenth they are graded to: 0.45 kn at 10, 0.25
    // at 6.
    EXPECT_LT(fastest_mps, 10.45 * kKnot_mps);
    EXPECT_GT(fastest_mps, 9.9 * kKnot_mps);
    EXPECT_LT(fastestInside_mps, 6.25 * kKnot_mps);
}

TEST_F(PilotOnTrack, TheStepEndsAtItsPlaceWithTheWheelAmidships) {
    engage({zoned(1000.0)});
    untilDone_s(1000.0);
    EXPECT_NEAR(s.motion().north_m, 1000.0, 1.0);
    EXPECT_EQ(s.state.steering.order_rad, 0.0);
    EXPECT_EQ(s.state.autopilot.mode, AutopilotMode::Off);
}

TEST_F(PilotOnTrack, SentAwayAndCalledAgainHeSteersOn) {
    engage({TrackStep{{}, 4.0, 1e9}});
    s.run(60.0);
    s.order(PilotOrder{false});
    s.order(HelmOrder{5.0 * kDegree_rad});  // a trainee sails her off the track
    s.run(30.0);
    ASSERT_GT(offTrack_m(), 5.0);
    s.order(PilotOrder{true});
    s.run(300.0);
    EXPECT_LT(offTrack_m(), 3.0);
    EXPECT_NEAR(wrapPi(s.motion().heading_rad), 0.0, 0.05);
}

TEST_F(PilotOnTrack, CalledAgainFarAlongTheTrackHeGoesOnFromThere) {
    engage({TrackStep{{}, 4.0, 1e9}});
    s.run(60.0);
    s.order(PilotOrder{false});
    s.order(AutopilotOrder{AutopilotMode::Heading, 0.0});
    s.run(300.0);  // a trainee sails on
    s.order(PilotOrder{true});
    s.run(120.0, [&] { ASSERT_NEAR(wrapPi(s.motion().heading_rad), 0.0, 0.3); });
    EXPECT_NEAR(s.state.autopilot.along_m, s.motion().north_m, 1.0);
}

// --- anchor ---

struct Approach {
    const char* name;
    NorthEast current;
};
class PilotAnchors : public Piloted, public ::testing::WithParamInterface<Approach> {};

TEST_P(PilotAnchors, OnTheMarkWithSternwayAndBringsHerUp) {
    const NorthEast mark{1000.0, 0.0};
    makeWay(TelegraphStep::DeadSlowAhead);
    s.current = GetParam().current;
    s.path = test::pathOf({{0.0, 0.0}, mark}, 0.0);
    const double cable_m = 4.1 * kShackle_m;
    engage({TrackStep{{}, 3.0 * kKnot_mps, 700.0},
            AnchorStep{mark, 0, 2 * kShackle_m, cable_m, 3.0 * kKnot_mps}});
    const AnchorState& anchor = s.state.anchors[0];
    while (anchor.status == AnchorStatus::Home && s.time_s < 3600.0) s.tick();
    ASSERT_EQ(anchor.status, AnchorStatus::Running);
    const double astern_kn =
        -dot(s.state.shownOverGround_mps, unitVector(s.motion().heading_rad)) / kKnot_mps;
    EXPECT_GE(astern_kn, 0.3);
    EXPECT_LE(astern_kn, 0.8);
    s.run(900.0);
    EXPECT_EQ(anchor.status, AnchorStatus::Held);
    EXPECT_LT(distance(anchor.position, mark), 50.0);
    EXPECT_NEAR(anchor.cableOut_m, cable_m, 0.5);
    EXPECT_LT(anchor.dragged_m, 10.0);
    EXPECT_LT(length(s.overGround_mps()), 0.3 * kKnot_mps);
    EXPECT_EQ(s.state.shafts[0].order_rps, 0.0);  // finished with engines
    EXPECT_FALSE(done());                         // he stays on watch
}
INSTANTIATE_TEST_SUITE_P(In, PilotAnchors,
                         ::testing::Values(Approach{"StillWater", {}},
                                           Approach{"AHeadCurrent", {-0.25, 0.0}}),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace sagara::core
