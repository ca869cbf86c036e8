#include "ui/input/Joysticks.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "VirtualStick.h"

namespace sagara::ui {
namespace {

TEST(Joysticks, WorkWithNothingPluggedIn) {
    Joysticks joysticks;
    EXPECT_TRUE(joysticks.trouble().isEmpty()) << joysticks.trouble().toStdString();
    joysticks.poll();
    EXPECT_TRUE(joysticks.devices().empty());
    EXPECT_EQ(joysticks.axis(3, 1), 0.0);
    EXPECT_FALSE(joysticks.button(3, 1));
}

TEST(Joysticks, ADeviceComesIsReadAndGoes) {
    Joysticks joysticks;
    QSignalSpy plugged(&joysticks, &Joysticks::plugged);
    QSignalSpy unplugged(&joysticks, &Joysticks::unplugged);
    test::VirtualStick stick(3, 4, 1);
    joysticks.poll();
    ASSERT_EQ(plugged.size(), 1);
    const auto devices = joysticks.devices();
    ASSERT_EQ(devices.size(), 1U);
    EXPECT_EQ(devices[0].axes, 3);
    EXPECT_EQ(devices[0].buttons, 4);
    EXPECT_EQ(devices[0].allButtons(), 8);
    EXPECT_EQ(devices[0].model.size(), 32U);

    stick.setAxis(1, -0.5);
    stick.setButton(2, true);
    stick.setHatUp(true);
    joysticks.poll();
    const int id = devices[0].id;
    EXPECT_NEAR(joysticks.axis(id, 1), -0.5, 1e-4);
    EXPECT_TRUE(joysticks.button(id, 2));
    EXPECT_TRUE(joysticks.button(id, 4));
    EXPECT_FALSE(joysticks.button(id, 5));

    stick.unplug();
    joysticks.poll();
    EXPECT_EQ(unplugged.size(), 1);
    EXPECT_TRUE(joysticks.devices().empty());
    EXPECT_EQ(joysticks.axis(id, 1), 0.0);
}

TEST(Joysticks, AStickPulledOutAndPutInTwentyTimesIsFoundEveryTime) {
    Joysticks joysticks;
    for (int i = 0; i < 20; ++i) {
        const test::VirtualStick stick(2, 2, 0);
        joysticks.poll();
        EXPECT_EQ(joysticks.devices().size(), 1U);
    }
    joysticks.poll();
    EXPECT_TRUE(joysticks.devices().empty());
}

TEST(Joysticks, WhereTheAxesStandIsToldOnce) {
    Joysticks joysticks;
    QSignalSpy moved(&joysticks, &Joysticks::axisMoved);
    const test::VirtualStick stick(2, 0, 0);
    joysticks.poll();
    EXPECT_EQ(moved.size(), 2);
    joysticks.poll();
    EXPECT_EQ(moved.size(), 2);
}

}  // namespace
}  // namespace sagara::ui
