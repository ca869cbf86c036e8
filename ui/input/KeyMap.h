#pragma once

#include <QKeySequence>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/input/ControlMap.h"

class QKeyEvent;
class QWidget;

namespace sagara::ui {

/// A key and what it does. One key of the keyboard with or without Shift, Ctrl, Alt.
struct KeyEntry {
    QKeySequence key;  ///< empty: no key
    BridgeAction action = BridgeAction::None;
    friend bool operator==(const KeyEntry&, const KeyEntry&) = default;
};
/// One entry for every action that is not None, in the order of BridgeAction.
using KeyMap = std::vector<KeyEntry>;

KeyMap usualKeys();
std::optional<BridgeAction> actionOf(const KeyMap& map, const QKeyEvent& event);
/// The action that has this key already, if any.
std::optional<BridgeAction> holderOf(const KeyMap& map, const QKeySequence& key);

std::string textOf(const KeyMap& map);
/// What is missing or makes no sense stays as usual.
KeyMap keyMapOf(std::string_view text);

/// Whoever has the keyboard needs the key for herself: fields for text, lists and sliders for the arrows.
bool keepsKey(const QWidget* focus, const QKeyEvent& event);

}  // namespace sagara::ui
