#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/input/BridgeInput.h"
#include "ui/settings/Section.h"
#include "ui/settings/SettingsStore.h"

class QComboBox;
class QGridLayout;
class QGroupBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace sagara::ui {

class AxisBar;
class CalibrationPanel;

/// Joysticks and wheels: what each axis and button does, live, with calibration.
class ControlsSection final : public Section {
    Q_OBJECT

public:
    ControlsSection(SettingsStore& store, BridgeInput& input, QWidget* parent);
    void setColours(PaletteName palette) override;
    void refresh() override;

private:
    struct AxisRow {
        AxisBar* bar;
        QComboBox* use;
        QComboBox* shaft;
    };
    void listDevices();
    void showDevice();
    void addAxis(QGridLayout* grid, int axis);
    void addButton(QGridLayout* grid, int button);
    QString buttonName(int button) const;
    void calibrate(int axis);
    void endCalibration();
    void keep();

    SettingsStore& m_store;
    BridgeInput& m_input;
    QComboBox* m_devices;
    QPushButton* m_usual;
    QStackedWidget* m_stack;
    QWidget* m_shown = nullptr;  ///< the controls of the device shown
    CalibrationPanel* m_calibration = nullptr;
    JoystickInfo m_device;
    ControlMap m_map;
    std::vector<AxisRow> m_axes;
    std::vector<QLabel*> m_lamps;  ///< one a button
    std::vector<bool> m_lit;
};

}  // namespace sagara::ui
