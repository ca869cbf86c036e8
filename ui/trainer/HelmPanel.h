#pragma once

#include <QWidget>
#include <vector>

#include "ui/run/ExerciseRun.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace sagara::ui {

class DriveSliders;

/// Rudder, telegraph, pitch, azimuth drives, thrusters and the scripted pilot of one own ship, worked from
/// the desk. Follows what others order.
class HelmPanel final : public QWidget {
    Q_OBJECT

public:
    HelmPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent = nullptr);
    void refresh();

private:
    void addThrusters(QFormLayout& form);

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    QCheckBox* m_pilot;
    QSlider* m_rudder;  ///< degrees, starboard to the right
    QLabel* m_order;
    std::vector<QComboBox*> m_telegraphs;
    DriveSliders* m_drives;
    std::vector<QSlider*> m_thrusters;  ///< tenths of full thrust, starboard to the right
    std::int64_t m_tick = 0;            ///< of what is shown
};

}  // namespace sagara::ui
