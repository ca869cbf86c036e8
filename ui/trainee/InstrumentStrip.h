#pragma once

#include <QWidget>

#include "core/exercise/Snapshot.h"
#include "ui/theme/PaletteName.h"
#include "ui/trainee/ShipReadings.h"

namespace sagara::ui::console {

class ClockGauge;
class DepthGauge;
class HeadingGauge;
class RudderGauge;
class ShaftGauge;
class SpeedGauge;
class WindGauge;

/// The instruments that are always in sight, in a row.
class InstrumentStrip final : public QWidget {
    Q_OBJECT

public:
    InstrumentStrip(const core::World& world, std::size_t ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void show(const core::Snapshot& now, const ShipReadings& readings, double depthAlarm_m);
    using QWidget::show;

private:
    const core::World& m_world;
    std::size_t m_ship;
    HeadingGauge* m_heading;
    SpeedGauge* m_speed;
    RudderGauge* m_rudder;
    ShaftGauge* m_shafts;
    WindGauge* m_wind;
    DepthGauge* m_depth;
    ClockGauge* m_clock;
};

}  // namespace sagara::ui::console
