#include "core/bridge/ShipOrders.h"

#include <gtest/gtest.h>

#include "BridgeShip.h"
#include "core/base/Archive.h"

namespace sagara::core {
namespace {

/// A patrol vessel with two lines ashore, both shafts stopped, both anchors home.
class ShipOrders : public ::testing::Test {
protected:
    OwnShip ship{"own", "Own", test::shippedShip("patrol51").vessel};
    OwnShipState state;
    const TelegraphTable& telegraph_rps = ship.vessel.propulsion.telegraph_rps;
    const double limit_rad = ship.vessel.steering.limit_rad;

    void SetUp() override {
        ship.lineIds = {"head", "stern"};
        ship.lines = {{{24.0, -1.6}, {30.0, -10.0}}, {{-24.0, -1.6}, {-30.0, -10.0}}};
        state = startOf(ship);
    }
    template <typename Order>
    void order(const Order& given) {
        obey(ship, state, given);
    }
    template <typename Order>
    void expectNothing(const Order& given) {
        const Bytes before = toBytes(state);
        order(given);
        EXPECT_EQ(toBytes(state), before);
    }
};

// --- helm and engines ---

TEST_F(ShipOrders, AHelmOrderIsHeldToTheRudderLimit) {
    order(HelmOrder{0.2});
    EXPECT_EQ(state.steering.order_rad, 0.2);
    order(HelmOrder{9.0});
    EXPECT_EQ(state.steering.order_rad, limit_rad);
    order(HelmOrder{-9.0});
    EXPECT_EQ(state.steering.order_rad, -limit_rad);
}

TEST_F(ShipOrders, AHandOnTheWheelTakesOverFromTheAutopilot) {
    order(AutopilotOrder{AutopilotMode::Heading, 1.0});
    EXPECT_EQ(state.autopilot.mode, AutopilotMode::Heading);
    EXPECT_EQ(state.autopilot.setHeading_rad, 1.0);
    order(HelmOrder{0.0});
    EXPECT_EQ(state.autopilot.mode, AutopilotMode::Off);
}

TEST_F(ShipOrders, EveryTelegraphStepIsAShaftSpeedOfTheVessel) {
    for (std::size_t i = 0; i < kTelegraphSteps; ++i) {
        order(TelegraphOrder{kAllShafts, static_cast<TelegraphStep>(i)});
        EXPECT_EQ(state.shafts[0].order_rps, telegraph_rps[i]);
        EXPECT_EQ(state.shafts[1].order_rps, telegraph_rps[i]);
    }
    order(TelegraphOrder{kAllShafts, TelegraphStep::Stop});
    EXPECT_EQ(state.shafts[0].order_rps, 0.0);
}

TEST_F(ShipOrders, ATelegraphHandleMovesItsOwnShaft) {
    order(TelegraphOrder{1, TelegraphStep::HalfAhead});
    EXPECT_EQ(state.shafts[0].order_rps, 0.0);
    EXPECT_GT(state.shafts[1].order_rps, 0.0);
}

TEST_F(ShipOrders, AShaftOrderIsHeldALittleBeyondTheFullSteps) {
    order(ShaftOrder{0, 1.5});
    EXPECT_EQ(state.shafts[0].order_rps, 1.5);
    EXPECT_EQ(state.shafts[1].order_rps, 0.0);
    order(ShaftOrder{kAllShafts, 1e9});
    EXPECT_DOUBLE_EQ(state.shafts[1].order_rps, 1.1 * telegraph_rps.back());
    order(ShaftOrder{kAllShafts, -1e9});
    EXPECT_DOUBLE_EQ(state.shafts[0].order_rps, 1.1 * telegraph_rps.front());
}

TEST_F(ShipOrders, ForWhatIsNotThereDoNothing) {
    expectNothing(TelegraphOrder{2, TelegraphStep::HalfAhead});
    expectNothing(TelegraphOrder{kAllShafts, static_cast<TelegraphStep>(9)});
    expectNothing(ShaftOrder{2, 1.0});
    expectNothing(LineOrder{2, LineAction::LetGo});
    expectNothing(AnchorOrder{2, AnchorAction::LetGo, 50.0});
}

// --- lines ---

TEST_F(ShipOrders, ALineOnItsBollardDoesAsItIsTold) {
    ASSERT_EQ(state.lines[0].status, LineStatus::Fast);
    const std::pair<LineAction, LineStatus> rows[] = {{LineAction::Slack, LineStatus::Slacking},
                                                      {LineAction::Heave, LineStatus::Heaving},
                                                      {LineAction::Hold, LineStatus::Fast},
                                                      {LineAction::LetGo, LineStatus::CastOff}};
    for (const auto& [action, status] : rows) {
        order(LineOrder{0, action});
        EXPECT_EQ(state.lines[0].status, status);
        EXPECT_EQ(state.lines[1].status, LineStatus::Fast);
    }
}

TEST_F(ShipOrders, ALineThatIsOffItsBollardCannotBeWorked) {
    for (const LineStatus off : {LineStatus::CastOff, LineStatus::In, LineStatus::Parted}) {
        state.lines[0].status = off;
        for (const LineAction action :
             {LineAction::Hold, LineAction::Slack, LineAction::Heave, LineAction::LetGo})
            expectNothing(LineOrder{0, action});
    }
}

// --- anchors ---

TEST_F(ShipOrders, AnAnchorAtHomeCanOnlyBeLetGo) {
    expectNothing(AnchorOrder{0, AnchorAction::Veer, 50.0});
    expectNothing(AnchorOrder{0, AnchorAction::Hold, 0.0});
    expectNothing(AnchorOrder{0, AnchorAction::HeaveIn, 0.0});
    order(AnchorOrder{0, AnchorAction::LetGo, 50.0});
    EXPECT_EQ(state.anchors[0].status, AnchorStatus::Running);
    EXPECT_EQ(state.anchors[0].stopAt_m, 50.0);
    EXPECT_EQ(state.anchors[1].status, AnchorStatus::Home);
}

TEST_F(ShipOrders, AnAnchorThatIsDownIsNotLetGoAgain) {
    state.anchors[0].status = AnchorStatus::Held;
    state.anchors[0].cableOut_m = 55.0;
    expectNothing(AnchorOrder{0, AnchorAction::LetGo, 100.0});
}

TEST_F(ShipOrders, CableIsVeeredToMoreAndHoveInToLess) {
    state.anchors[0].status = AnchorStatus::Held;
    state.anchors[0].cableOut_m = 55.0;
    expectNothing(AnchorOrder{0, AnchorAction::Veer, 55.0});
    expectNothing(AnchorOrder{0, AnchorAction::Veer, 30.0});
    expectNothing(AnchorOrder{0, AnchorAction::HeaveIn, 55.0});
    expectNothing(AnchorOrder{0, AnchorAction::HeaveIn, 80.0});
    order(AnchorOrder{0, AnchorAction::Veer, 110.0});
    EXPECT_EQ(state.anchors[0].status, AnchorStatus::Veering);
    EXPECT_EQ(state.anchors[0].stopAt_m, 110.0);
    order(AnchorOrder{0, AnchorAction::HeaveIn, 20.0});
    EXPECT_EQ(state.anchors[0].status, AnchorStatus::Heaving);
    EXPECT_EQ(state.anchors[0].stopAt_m, 20.0);
    order(AnchorOrder{0, AnchorAction::Hold, 0.0});
    EXPECT_EQ(state.anchors[0].status, AnchorStatus::Held);
}

TEST_F(ShipOrders, NoMoreCableIsOrderedThanThereIs) {
    const double all_m = ship.vessel.groundTackle.anchors[0].cableLength_m;
    order(AnchorOrder{0, AnchorAction::LetGo, 1e9});
    EXPECT_EQ(state.anchors[0].stopAt_m, all_m);
    state.anchors[0].status = AnchorStatus::Held;
    state.anchors[0].cableOut_m = 55.0;
    order(AnchorOrder{0, AnchorAction::HeaveIn, -10.0});
    EXPECT_EQ(state.anchors[0].stopAt_m, 0.0);
}

TEST_F(ShipOrders, ALostAnchorObeysNothing) {
    state.anchors[0].status = AnchorStatus::CableParted;
    for (const AnchorAction action :
         {AnchorAction::LetGo, AnchorAction::Veer, AnchorAction::Hold, AnchorAction::HeaveIn})
        expectNothing(AnchorOrder{0, action, 50.0});
}

// --- autopilot and pilot ---

TEST_F(ShipOrders, AnAutopilotOrderForgetsWhatTheLastTrackHadGathered) {
    state.autopilot.offTrackSum_ms = 500.0;
    order(AutopilotOrder{AutopilotMode::Track, 0.0});
    EXPECT_EQ(state.autopilot.mode, AutopilotMode::Track);
    EXPECT_EQ(state.autopilot.offTrackSum_ms, 0.0);
}

TEST_F(ShipOrders, ThePilotGivesTheShipBackWithTheAutopilotOff) {
    order(PilotOrder{true});
    EXPECT_TRUE(state.pilot.engaged);
    state.autopilot.mode = AutopilotMode::Track;
    state.pilot.step = 3;
    order(PilotOrder{false});
    EXPECT_FALSE(state.pilot.engaged);
    EXPECT_EQ(state.autopilot.mode, AutopilotMode::Off);
    EXPECT_EQ(state.pilot.step, 3u);  // he remembers how far he was
}

TEST_F(ShipOrders, SendingAwayAPilotWhoHasNotTheShipDoesNothing) {
    order(AutopilotOrder{AutopilotMode::Heading, 1.0});
    expectNothing(PilotOrder{false});
}

TEST_F(ShipOrders, CallingAPilotWhoHasTheShipDoesNothing) {
    order(PilotOrder{true});
    state.pilot.since_s = 12.0;
    expectNothing(PilotOrder{true});
}

}  // namespace
}  // namespace sagara::core
