#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/run/ExerciseRun.h"

class QLabel;

namespace sagara::ui {

/// What the instruments of one own ship say: label, value, unit in rows.
class Instruments final : public QWidget {
    Q_OBJECT

public:
    Instruments(const core::World& world, std::size_t ship, QWidget* parent = nullptr);
    void show(const core::Snapshot& now);
    using QWidget::show;

private:
    QLabel* row(const QString& name, const QString& unit, const QString& tip);

    const core::World& m_world;
    std::size_t m_ship;
    QLabel *m_heading, *m_course, *m_speedOverGround, *m_speedThroughWater, *m_rateOfTurn, *m_drift, *m_pivot,
        *m_rudder, *m_wind, *m_depth, *m_roll, *m_pitch;
    std::vector<QLabel*> m_shafts;
    std::vector<QLabel*> m_bladePitches, m_drives;  ///< as m_shafts, null where she has none
};

/// Where the ship turns about: distance ahead of midship of the point without sideways speed; nothing when
/// she hardly turns.
std::optional<double> pivotAhead_m(const core::ShipMotion& motion);

}  // namespace sagara::ui
