#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"
#include "ui/trainee/ShipReadings.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace sagara::ui::console {

/// Hand or autopilot, and the heading the autopilot steers.
class AutopilotPanel final : public QWidget {
    Q_OBJECT

public:
    AutopilotPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent = nullptr);
    void show(const core::OwnShipView& ship, const ShipReadings& readings);
    using QWidget::show;

private:
    void engage();

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    QLabel* m_mode;
    QPushButton *m_hand, *m_heading;
    QSpinBox* m_set;  ///< degrees, true
    double m_convergence_rad = 0.0;
    bool m_on = false;
};

}  // namespace sagara::ui::console
