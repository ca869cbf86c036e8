#include <gtest/gtest.h>

#include <QKeyEvent>

#include "ui/input/KeyMap.h"

namespace sagara::ui {
namespace {

TEST(Keys, EveryUsualKeyIsUsedOnce) {
    const KeyMap keys = usualKeys();
    EXPECT_EQ(keys.size(), static_cast<std::size_t>(kBridgeActions - 1));
    for (const KeyEntry& entry : keys) {
        EXPECT_FALSE(entry.key.isEmpty()) << actionName(entry.action);
        EXPECT_EQ(holderOf(keys, entry.key), entry.action);
    }
}

TEST(Keys, GoToTextAndBack) {
    KeyMap keys = usualKeys();
    keys[0].key = QKeySequence(Qt::CTRL | Qt::Key_F5);
    keys[1].key = {};
    EXPECT_EQ(keyMapOf(textOf(keys)), keys);
    EXPECT_EQ(keyMapOf("nonsense"), usualKeys());
}

TEST(Keys, ModifiersTellKeysApartAndTheKeypadDoesNot) {
    const KeyMap keys = usualKeys();
    EXPECT_EQ(actionOf(keys, QKeyEvent(QEvent::KeyPress, Qt::Key_Left, Qt::NoModifier)),
              BridgeAction::RudderPort);
    EXPECT_EQ(actionOf(keys, QKeyEvent(QEvent::KeyPress, Qt::Key_Left, Qt::KeypadModifier)),
              BridgeAction::RudderPort);
    EXPECT_EQ(actionOf(keys, QKeyEvent(QEvent::KeyPress, Qt::Key_Left, Qt::ShiftModifier)),
              BridgeAction::RudderPortFine);
    EXPECT_FALSE(actionOf(keys, QKeyEvent(QEvent::KeyPress, Qt::Key_Left, Qt::ControlModifier)));
    EXPECT_FALSE(actionOf(keys, QKeyEvent(QEvent::KeyPress, Qt::Key_Shift, Qt::ShiftModifier)));
}

}  // namespace
}  // namespace sagara::ui
