#pragma once

#include "ui/input/BridgeInput.h"
#include "ui/settings/Section.h"
#include "ui/settings/SettingsStore.h"

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace sagara::ui {

/// A home-made bridge in, instruments out.
class NmeaSection final : public Section {
    Q_OBJECT

public:
    NmeaSection(SettingsStore& store, BridgeInput& input, QWidget* parent);
    void refresh() override;

private:
    QGroupBox* inputGroup();
    QGroupBox* outputGroup();
    void listPorts();
    void take();
    void enable();

    SettingsStore& m_store;
    NmeaPort& m_port;
    QComboBox* m_source;
    QSpinBox* m_udpPort;
    QComboBox* m_serialPort;
    QPushButton* m_look;
    QComboBox* m_baud;
    QLabel* m_state;
    QLabel* m_last;
    QLabel* m_counts;
    QLabel* m_error;
    QCheckBox* m_output;
    QLineEdit* m_host;
    QLabel* m_hostTrouble;
    QSpinBox* m_outputPort;
    QSpinBox* m_rate;
    QLabel* m_sent;
};

}  // namespace sagara::ui
