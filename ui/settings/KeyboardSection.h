#pragma once

#include <map>

#include "ui/input/BridgeInput.h"
#include "ui/settings/Section.h"
#include "ui/settings/SettingsStore.h"

class QKeySequenceEdit;
class QLabel;

namespace sagara::ui {

/// Which key does what.
class KeyboardSection final : public Section {
    Q_OBJECT

public:
    KeyboardSection(SettingsStore& store, BridgeInput& input, QWidget* parent);

private:
    QWidget* group(const QString& title, std::initializer_list<BridgeAction> actions);
    void take(BridgeAction action);
    void showKeys();
    void keep(const KeyMap& keys);

    SettingsStore& m_store;
    BridgeInput& m_input;
    std::map<BridgeAction, QKeySequenceEdit*> m_fields;
    QLabel* m_trouble;
};

}  // namespace sagara::ui
