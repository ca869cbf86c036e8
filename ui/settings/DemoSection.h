#pragma once

#include "ui/settings/Section.h"
#include "ui/settings/SettingsStore.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;

namespace sagara::ui {

/// How an exhibition is left: a chord and a PIN.
class DemoSection final : public Section {
    Q_OBJECT

public:
    DemoSection(SettingsStore& store, QWidget* parent);

private:
    void takePin();
    void takeChord();
    void tell();

    SettingsStore& m_store;
    QLineEdit* m_pin;
    QLabel* m_pinTrouble;
    QKeySequenceEdit* m_chord;
    QLabel* m_chordTrouble;
    QLabel* m_usual;
};

}  // namespace sagara::ui
