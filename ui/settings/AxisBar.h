#pragma once

#include <QWidget>

#include "ui/input/Calibration.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// Where an axis stands: the calibrated value as a bar from the middle, the raw reading as a mark below it
/// between the ends that were found.
class AxisBar final : public QWidget {
    Q_OBJECT

public:
    explicit AxisBar(QWidget* parent = nullptr);
    void setColours(PaletteName palette);
    void show(const AxisCalibration& calibration, double raw);
    double value() const { return m_value; }
    QSize sizeHint() const override { return {220, 24}; }
    QSize minimumSizeHint() const override { return {90, 24}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    PaletteName m_palette = PaletteName::Day;
    AxisCalibration m_calibration;
    double m_raw = 0.0;
    double m_value = 0.0;
};

}  // namespace sagara::ui
