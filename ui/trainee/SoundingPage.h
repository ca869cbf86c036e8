#pragma once

#include <QWidget>

#include "core/bridge/Sonar.h"
#include "core/exercise/Snapshot.h"
#include "ui/theme/PaletteName.h"
#include "ui/trainee/ShipReadings.h"

class QComboBox;
class QDoubleSpinBox;

namespace sagara::ui::console {

class SonarView;
class SounderView;

/// Sonar and echo sounder side by side with their settings.
class SoundingPage final : public QWidget {
    Q_OBJECT

public:
    SoundingPage(const core::World& world, std::size_t ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    /// The sounder at every call; the sonar once a second of the exercise, while it is in sight.
    void show(const core::Snapshot& now, const ShipReadings& readings);
    using QWidget::show;
    double depthAlarm_m() const;

private:
    void sound(const core::Snapshot& now);

    const core::World& m_world;
    std::size_t m_ship;
    core::Sonar m_sonar;
    SonarView* m_sonarView;
    SounderView* m_sounderView;
    QComboBox* m_range;
    QDoubleSpinBox* m_alarm;
    std::int64_t m_pinged_s = -1;
    bool m_pingNow = true;
};

}  // namespace sagara::ui::console
