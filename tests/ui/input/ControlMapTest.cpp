#include "ui/input/ControlMap.h"

#include <gtest/gtest.h>

#include <random>

#include "ui/input/KeyMap.h"
#include "ui/input/NmeaPort.h"

namespace sagara::ui {
namespace {

ControlMap sample() {
    ControlMap map = usualMap(4, 6, 1);
    map.axes[1] = {AxisUse::Telegraph, 1, {-0.9, 0.05, 0.8, 0.1, true}};
    map.axes[2] = {AxisUse::Thruster, kEveryShaft, {}};
    map.axes[3] = {AxisUse::Look, kEveryShaft, {}};
    map.buttons[3] = {BridgeAction::TelegraphDown, 2};
    return map;
}

TEST(ControlMap, GoesToTextAndBack) {
    const auto back = controlMapOf(textOf(sample()));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, sample());
}

TEST(ControlMap, ANewDeviceSteersAndDoesNotRingTheTelegraphByAnAxis) {
    const ControlMap map = usualMap(3, 2, 1);
    EXPECT_EQ(map.axes[0].use, AxisUse::Rudder);
    for (const AxisMap& axis : map.axes) EXPECT_NE(axis.use, AxisUse::Telegraph);
    EXPECT_EQ(map.buttons.size(), 6U);
    EXPECT_EQ(map.buttons[2].action, BridgeAction::TelegraphUp);
    EXPECT_TRUE(usualMap(0, 0, 0).axes.empty());
}

TEST(ControlMap, TextThatIsNoMapIsRefusedAndNonsenseInItMended) {
    EXPECT_FALSE(controlMapOf(""));
    EXPECT_FALSE(controlMapOf("[]"));
    EXPECT_FALSE(controlMapOf("{\"axes\":3,\"buttons\":[]}"));
    const auto map = controlMapOf(
        R"({"axes":[{"use":"fly","shaft":77,"least":5,"most":-5}],"buttons":[{"action":"explode"},7]})");
    ASSERT_TRUE(map);
    EXPECT_EQ(map->axes[0], AxisMap{});
    EXPECT_EQ(map->buttons[0], ButtonMap{});
    EXPECT_EQ(map->buttons.size(), 2U);
}

TEST(ControlMap, NoTextBreaksTheReaders) {
    std::mt19937 random(7);
    const std::string whole = textOf(sample());
    for (int i = 0; i < 3000; ++i) {
        std::string text = whole;
        for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random());
        text.resize(random() % text.size());
        const auto map = controlMapOf(text);
        for (const AxisMap& axis : map ? map->axes : std::vector<AxisMap>())
            EXPECT_TRUE(usable(axis.calibration));
        EXPECT_EQ(keyMapOf(text).size(), usualKeys().size());
        nmeaSettingsOf(text);
    }
}

TEST(ControlMap, EveryActionHasANameAndWords) {
    for (int i = 0; i < kBridgeActions; ++i) {
        const auto action = static_cast<BridgeAction>(i);
        EXPECT_FALSE(actionText(action).isEmpty());
        EXPECT_EQ(actionByName(actionName(action)), action);
    }
    EXPECT_FALSE(actionByName("explode"));
}

TEST(NmeaSettings, GoToTextAndBack) {
    NmeaSettings s;
    s.source = NmeaSource::Serial;
    s.serialPort = QStringLiteral("ttyUSB0");
    s.baud = 38400;
    s.output = true;
    s.outputHost = QStringLiteral("192.168.1.255");
    s.output_Hz = 5;
    EXPECT_EQ(nmeaSettingsOf(textOf(s)), s);
    EXPECT_EQ(nmeaSettingsOf("nonsense"), NmeaSettings{});
    EXPECT_EQ(nmeaSettingsOf(R"({"udpPort":99999999,"output_Hz":0,"outputHost":"nobody"})"), NmeaSettings{});
}

}  // namespace
}  // namespace sagara::ui
