#include "ui/input/KeyMap.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTabBar>
#include <QTextEdit>
#include <array>

namespace sagara::ui {
namespace {

constexpr auto kModifiers = Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;

QKeySequence usualKey(BridgeAction action) {
    switch (action) {
        case BridgeAction::None:
            return {};
        case BridgeAction::Horn:
            return QKeySequence(Qt::Key_H);
        case BridgeAction::TelegraphUp:
            return QKeySequence(Qt::Key_PageUp);
        case BridgeAction::TelegraphDown:
            return QKeySequence(Qt::Key_PageDown);
        case BridgeAction::StopEngines:
            return QKeySequence(Qt::Key_End);
        case BridgeAction::RudderPort:
            return QKeySequence(Qt::Key_Left);
        case BridgeAction::RudderStarboard:
            return QKeySequence(Qt::Key_Right);
        case BridgeAction::RudderPortFine:
            return QKeySequence(Qt::SHIFT | Qt::Key_Left);
        case BridgeAction::RudderStarboardFine:
            return QKeySequence(Qt::SHIFT | Qt::Key_Right);
        case BridgeAction::Midships:
            return QKeySequence(Qt::Key_Home);
        case BridgeAction::ThrusterPort:
            return QKeySequence(Qt::Key_J);
        case BridgeAction::ThrusterStarboard:
            return QKeySequence(Qt::Key_L);
        case BridgeAction::ThrusterStop:
            return QKeySequence(Qt::Key_K);
        case BridgeAction::LookLeft:
            return QKeySequence(Qt::Key_Q);
        case BridgeAction::LookRight:
            return QKeySequence(Qt::Key_E);
        case BridgeAction::Acknowledge:
            return QKeySequence(Qt::Key_A);
        case BridgeAction::Bookmark:
            return QKeySequence(Qt::Key_B);
        case BridgeAction::SternThrusterPort:
            return QKeySequence(Qt::SHIFT | Qt::Key_J);
        case BridgeAction::SternThrusterStarboard:
            return QKeySequence(Qt::SHIFT | Qt::Key_L);
        case BridgeAction::SternThrusterStop:
            return QKeySequence(Qt::SHIFT | Qt::Key_K);
        case BridgeAction::PitchAstern:
            return QKeySequence(Qt::Key_U);
        case BridgeAction::PitchAhead:
            return QKeySequence(Qt::Key_I);
        case BridgeAction::AzimuthPort:
            return QKeySequence(Qt::Key_O);
        case BridgeAction::AzimuthStarboard:
            return QKeySequence(Qt::Key_P);
    }
    return {};
}

bool isArrow(int key) {
    constexpr std::array<int, 8> kMoving{Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Up,   Qt::Key_Down,
                                         Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_End};
    return std::find(kMoving.begin(), kMoving.end(), key) != kMoving.end();
}

template <typename... Widgets>
bool isA(const QWidget* widget) {
    return ((qobject_cast<const Widgets*>(widget) != nullptr) || ...);
}

}  // namespace

KeyMap usualKeys() {
    KeyMap map;
    for (int i = 1; i < kBridgeActions; ++i) {
        const auto action = static_cast<BridgeAction>(i);
        map.push_back({usualKey(action), action});
    }
    return map;
}

std::optional<BridgeAction> holderOf(const KeyMap& map, const QKeySequence& key) {
    if (key.isEmpty()) return std::nullopt;
    for (const KeyEntry& entry : map)
        if (entry.key == key) return entry.action;
    return std::nullopt;
}

std::optional<BridgeAction> actionOf(const KeyMap& map, const QKeyEvent& event) {
    const int key = event.key();
    if (key == 0 || key == Qt::Key_unknown) return std::nullopt;
    return holderOf(map, QKeySequence(QKeyCombination(event.modifiers() & kModifiers, Qt::Key(key))));
}

std::string textOf(const KeyMap& map) {
    QJsonObject all;
    for (const KeyEntry& entry : map)
        all[QString::fromLatin1(actionName(entry.action))] = entry.key.toString(QKeySequence::PortableText);
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

KeyMap keyMapOf(std::string_view text) {
    const QJsonObject all =
        QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size()))).object();
    KeyMap map = usualKeys();
    for (KeyEntry& entry : map) {
        const QJsonValue value = all[QString::fromLatin1(actionName(entry.action))];
        if (!value.isString()) continue;
        const QKeySequence key(value.toString(), QKeySequence::PortableText);
        if (value.toString().isEmpty() || (key.count() == 1 && key[0].key() != Qt::Key_unknown))
            entry.key = key;
    }
    return map;
}

bool keepsKey(const QWidget* focus, const QKeyEvent& event) {
    if (focus == nullptr) return false;
    const bool plain = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == Qt::NoModifier;
    if (isA<QLineEdit, QAbstractSpinBox, QTextEdit, QPlainTextEdit, QKeySequenceEdit>(focus)) return true;
    if (isA<QComboBox, QAbstractItemView>(focus)) return plain;  // letters search in them
    return isA<QAbstractSlider, QTabBar>(focus) && isArrow(event.key());
}

}  // namespace sagara::ui
