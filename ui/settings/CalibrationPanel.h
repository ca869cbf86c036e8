#pragma once

#include <QFrame>

#include "ui/input/Calibration.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QPushButton;

namespace sagara::ui {

class AxisBar;

/// The steps of calibrating one axis, in words, with what is read.
class CalibrationPanel final : public QFrame {
    Q_OBJECT

public:
    CalibrationPanel(int axis, const QString& name, const AxisCalibration& before, QWidget* parent);
    int axis() const { return m_axis; }
    void feed(double raw);
    void setColours(PaletteName palette);

Q_SIGNALS:
    void found(const sagara::ui::AxisCalibration& calibration);
    void cancelled();

private:
    void goOn();
    void tell();
    int m_axis;
    CalibrationRun m_run;
    QLabel* m_step;
    QLabel* m_read;
    AxisBar* m_bar;
    QPushButton* m_next;
};

}  // namespace sagara::ui
