#include "ui/input/BridgeInput.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "VirtualStick.h"
#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using core::TelegraphStep;
constexpr double kLimit_rad = 35.0 * core::kDegree_rad;

class BridgeInputs : public testing::Test {
protected:
    BridgeInputs() { input.setShip({2, kLimit_rad}); }
    void poll() { input.joysticks().poll(); }
    JoystickInfo device() {
        const auto devices = input.joysticks().devices();
        return devices.empty() ? JoystickInfo{} : devices.front();
    }

    BridgeInput input;
    QSignalSpy helm{&input, &BridgeInput::helmWanted};
    QSignalSpy telegraph{&input, &BridgeInput::telegraphWanted};
    QSignalSpy thruster{&input, &BridgeInput::thrusterWanted};
    QSignalSpy horn{&input, &BridgeInput::hornWanted};
    QSignalSpy look{&input, &BridgeInput::lookWanted};
    QSignalSpy activity{&input, &BridgeInput::anyActivity};
    QSignalSpy lost{&input, &BridgeInput::deviceLost};
};

TEST_F(BridgeInputs, AStickSteersFromTheMomentItIsMoved) {
    test::VirtualStick stick(2, 2, 1);
    poll();
    EXPECT_TRUE(helm.isEmpty());  // plugging in is no order
    EXPECT_TRUE(activity.isEmpty());
    stick.setAxis(0, 1.0);
    poll();
    ASSERT_EQ(helm.size(), 1);
    EXPECT_NEAR(helm[0][0].toDouble(), kLimit_rad, 1e-9);
    EXPECT_EQ(activity.size(), 1);
    stick.setAxis(0, 0.0);
    poll();
    ASSERT_EQ(helm.size(), 2);
    EXPECT_EQ(helm[1][0].toDouble(), 0.0);
    poll();
    EXPECT_EQ(helm.size(), 2);  // nothing moved, nothing wanted
}

TEST_F(BridgeInputs, ALeverRingsTheTelegraphOfItsShaft) {
    test::VirtualStick stick(2, 0, 0);
    poll();
    ControlMap map = input.mapOf(device());
    map.axes[1] = {AxisUse::Telegraph, 1, {}};
    map.axes[1].calibration.inverted = true;  // a stick pushed forward reads -1
    input.setMap(device().model, map);
    stick.setAxis(1, -1.0);
    poll();
    ASSERT_EQ(telegraph.size(), 1);
    EXPECT_EQ(telegraph[0][0].toInt(), 1);
    EXPECT_EQ(telegraph[0][1].value<TelegraphStep>(), TelegraphStep::FullAhead);
    EXPECT_TRUE(helm.isEmpty());
}

TEST_F(BridgeInputs, ThrusterAndLookFollowTheirAxes) {
    test::VirtualStick stick(2, 0, 0);
    poll();
    ControlMap map = input.mapOf(device());
    map.axes[0].use = AxisUse::Thruster;
    map.axes[1].use = AxisUse::Look;
    input.setMap(device().model, map);
    stick.setAxis(0, -1.0);
    stick.setAxis(1, 1.0);
    poll();
    ASSERT_EQ(thruster.size(), 1);
    EXPECT_NEAR(thruster[0][0].toDouble(), -1.0, 1e-4);
    ASSERT_EQ(look.size(), 1);
    EXPECT_GT(look[0][0].toDouble(), 0.0);
}

TEST_F(BridgeInputs, ThrustersStepFromWhatWasOrderedOtherwise) {
    QSignalSpy stern(&input, &BridgeInput::sternThrusterWanted);
    input.followThruster(0.5);
    input.perform(BridgeAction::ThrusterStarboard, kEveryShaft, true);
    EXPECT_NEAR(thruster[0][0].toDouble(), 0.7, 1e-12);
    input.perform(BridgeAction::SternThrusterPort, kEveryShaft, true);
    EXPECT_NEAR(stern[0][0].toDouble(), -0.2, 1e-12);
    input.obey(NmeaThruster{0.3, true});
    EXPECT_NEAR(stern[1][0].toDouble(), 0.3, 1e-12);
    EXPECT_EQ(thruster.size(), 1);
    input.perform(BridgeAction::SternThrusterStop, kEveryShaft, true);
    EXPECT_EQ(stern[2][0].toDouble(), 0.0);
}

TEST_F(BridgeInputs, PitchAndAzimuthAreOfOneShaftOrOfAll) {
    QSignalSpy pitch(&input, &BridgeInput::pitchWanted), azimuth(&input, &BridgeInput::azimuthWanted);
    QSignalSpy pitchShift(&input, &BridgeInput::pitchShiftWanted);
    QSignalSpy azimuthShift(&input, &BridgeInput::azimuthShiftWanted);
    test::VirtualStick stick(2, 0, 0);
    poll();
    ControlMap map = input.mapOf(device());
    map.axes[0] = {AxisUse::Pitch, 1, {}};
    map.axes[1] = {AxisUse::Azimuth, kEveryShaft, {}};
    input.setMap(device().model, map);
    stick.setAxis(0, -1.0);
    stick.setAxis(1, 1.0);
    poll();
    ASSERT_EQ(pitch.size(), 1);
    EXPECT_EQ(pitch[0][0].toInt(), 1);
    EXPECT_NEAR(pitch[0][1].toDouble(), -1.0, 1e-4) << "the design pitch, astern";
    ASSERT_EQ(azimuth.size(), 2);
    EXPECT_NEAR(azimuth[1][1].toDouble(), core::kPi, 1e-3) << "all the way to the right is aft";
    input.perform(BridgeAction::PitchAhead, kEveryShaft, true);
    ASSERT_EQ(pitchShift.size(), 2);
    EXPECT_EQ(pitchShift[1][1].toInt(), 2) << "10 %";
    input.perform(BridgeAction::AzimuthPort, 0, true);
    ASSERT_EQ(azimuthShift.size(), 1);
    EXPECT_EQ(azimuthShift[0][1].toInt(), -3) << "15 degrees";
    EXPECT_TRUE(needsShaft(AxisUse::Azimuth));
    EXPECT_FALSE(needsShaft(AxisUse::Rudder));
}

TEST_F(BridgeInputs, TheHornStopsWhenTheStickIsTornOut) {
    test::VirtualStick stick(1, 2, 0);
    poll();
    stick.setButton(0, true);
    poll();
    ASSERT_EQ(horn.size(), 1);
    EXPECT_TRUE(horn[0][0].toBool());
    stick.unplug();
    poll();
    ASSERT_EQ(horn.size(), 2);
    EXPECT_FALSE(horn[1][0].toBool());
    ASSERT_EQ(lost.size(), 1);
    EXPECT_FALSE(lost[0][0].toString().isEmpty());
    EXPECT_TRUE(helm.isEmpty());  // the rudder stays where it was ordered
    test::VirtualStick again(1, 2, 0);
    poll();
    again.setAxis(0, 0.5);
    poll();
    EXPECT_EQ(helm.size(), 1);
}

TEST_F(BridgeInputs, ButtonsAndKeysStepFromWhatWasOrderedOtherwise) {
    input.followHelm(0.1);
    input.perform(BridgeAction::RudderPort, kEveryShaft, true);
    EXPECT_NEAR(helm[0][0].toDouble(), 0.1 - 5.0 * core::kDegree_rad, 1e-12);
    input.followTelegraph(0, TelegraphStep::HalfAhead);
    input.perform(BridgeAction::TelegraphUp, kEveryShaft, true);
    ASSERT_EQ(telegraph.size(), 2);
    EXPECT_EQ(telegraph[0][1].value<TelegraphStep>(), TelegraphStep::FullAhead);
    EXPECT_EQ(telegraph[1][1].value<TelegraphStep>(), TelegraphStep::DeadSlowAhead);
    input.perform(BridgeAction::StopEngines, 1, true);
    ASSERT_EQ(telegraph.size(), 3);
    EXPECT_EQ(telegraph[2][0].toInt(), 1);
    for (int i = 0; i < 20; ++i) input.perform(BridgeAction::RudderStarboard, kEveryShaft, true);
    EXPECT_DOUBLE_EQ(helm.back()[0].toDouble(), kLimit_rad);
}

TEST_F(BridgeInputs, OrdersOfAHomeMadeBridgeAreWishesLikeAnyOther) {
    input.nmea().feed(withChecksum("IIROR,-10.0,A,,V,B") + "\r\n" + withChecksum("IIETL,,O,03,,B,1") +
                      "\r\n" + withChecksum("IIETL,,O,00,,B,0") + "\r\n" +
                      withChecksum("IITRC,1,50,P,,V,,B,C") + "\r\n" + withChecksum("PSGR,HORN,1") + "\r\n" +
                      withChecksum("IIPRC,-100,A,,V,,V,B,2") + "\r\n");
    EXPECT_NEAR(helm[0][0].toDouble(), -10.0 * core::kDegree_rad, 1e-12);
    ASSERT_EQ(telegraph.size(), 4);
    EXPECT_EQ(telegraph[0][0].toInt(), 1);  // starboard
    EXPECT_EQ(telegraph[0][1].value<TelegraphStep>(), TelegraphStep::HalfAhead);
    EXPECT_EQ(telegraph[1][1].value<TelegraphStep>(), TelegraphStep::Stop);
    EXPECT_EQ(telegraph[2][0].toInt(), 1);  // engine 0 of two: both
    EXPECT_EQ(telegraph[3][0].toInt(), 0);  // port lever
    EXPECT_EQ(telegraph[3][1].value<TelegraphStep>(), TelegraphStep::FullAstern);
    EXPECT_EQ(thruster[0][0].toDouble(), 0.5);
    EXPECT_TRUE(horn[0][0].toBool());
}

TEST_F(BridgeInputs, ABridgeThatRepeatsItsOrdersGivesThemOnce) {
    for (int i = 0; i < 50; ++i) {
        input.obey(NmeaRudder{0.1});
        input.obey(NmeaTelegraph{1, TelegraphStep::SlowAhead});
        input.obey(NmeaLever{2, 0.5});
        input.obey(NmeaThruster{0.0});
        input.obey(NmeaHorn{false});
    }
    EXPECT_EQ(helm.size(), 1);
    EXPECT_EQ(telegraph.size(), 2);
    EXPECT_EQ(thruster.size(), 1);
    EXPECT_EQ(activity.size(), 5);
    input.obey(NmeaRudder{0.12});
    EXPECT_EQ(helm.size(), 2);
    input.setShip({2, kLimit_rad});
    input.obey(NmeaRudder{0.12});
    EXPECT_EQ(helm.size(), 3);  // another ship has not heard it
}

TEST_F(BridgeInputs, KeysOfTheWatchedWindowAreOrdersExceptInAField) {
    QWidget window;
    QWidget pane(&window);
    pane.setFocusPolicy(Qt::StrongFocus);
    QLineEdit field(&window);
    window.show();
    input.watchKeys(&window);
    QTest::keyClick(&pane, Qt::Key_Left);
    ASSERT_EQ(helm.size(), 1);
    EXPECT_NEAR(helm[0][0].toDouble(), -5.0 * core::kDegree_rad, 1e-12);
    QTest::keyClick(&pane, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_NEAR(helm[1][0].toDouble(), -4.0 * core::kDegree_rad, 1e-12);
    QTest::keyPress(&pane, Qt::Key_H);
    ASSERT_EQ(horn.size(), 1);
    QTest::keyRelease(&pane, Qt::Key_H);
    ASSERT_EQ(horn.size(), 2);
    EXPECT_FALSE(horn[1][0].toBool());
    QTest::keyClick(&field, Qt::Key_H);
    EXPECT_EQ(horn.size(), 2);
    EXPECT_EQ(field.text(), QStringLiteral("h"));
    QTest::keyPress(&pane, Qt::Key_H);
    QEvent away(QEvent::WindowDeactivate);
    QApplication::sendEvent(&window, &away);
    EXPECT_EQ(horn.size(), 4);  // another window came in front
    QTest::keyPress(&pane, Qt::Key_H);
    input.watchKeys(nullptr);
    EXPECT_EQ(horn.size(), 6);  // let go with the window
    QTest::keyClick(&pane, Qt::Key_Left);
    EXPECT_EQ(helm.size(), 2);
}

TEST_F(BridgeInputs, KeysReachABridgeThatIsAPageOfAWindow) {
    QWidget window;
    QWidget page(&window), pane(&page), header(&window);
    window.show();
    input.watchKeys(&page);
    QTest::keyClick(&pane, Qt::Key_Left);
    QTest::keyClick(&header, Qt::Key_Left);
    EXPECT_EQ(helm.size(), 2);
    page.hide();  // another page has come in front
    QTest::keyClick(&header, Qt::Key_Left);
    EXPECT_EQ(helm.size(), 2);
    QWidget other;
    other.show();
    page.show();
    QTest::keyClick(&other, Qt::Key_Left);
    EXPECT_EQ(helm.size(), 2);
}

}  // namespace
}  // namespace sagara::ui
