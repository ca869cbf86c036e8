#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <vector>

#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"
#include "ui/trainee/ShipReadings.h"

class QTabWidget;

namespace sagara::ui::console {

class AnchorPanel;
class AutopilotPanel;
class BearingList;
class HelmWheel;
class LinePanel;
class ShaftTelegraph;
class ThrusterLever;

/// What is worked from the bridge: telegraphs, wheel, autopilot, deck. Follows what others order.
class ControlRow final : public QWidget {
    Q_OBJECT

public:
    ControlRow(ExerciseRun& run, std::size_t ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    /// Widths follow the height of the row.
    void setUnit(double unit);
    void show(const core::Snapshot& now, const ShipReadings& readings);
    using QWidget::show;
    BearingList& bearings() { return *m_bearings; }

    /// From a joystick or a bridge of other make: any angle, no whole degrees.
    void setHelm(double rudder_rad);
    void setTelegraph(int shaft, core::TelegraphStep step);
    void setThruster(int thruster, double share);
    void turnHelmBy(double rudder_rad);
    void midships();
    void moveTelegraphs(int steps);

Q_SIGNALS:
    /// Whoever gave it: for input devices that have to follow.
    void helmGiven(double rudder_rad);
    void telegraphGiven(int shaft, sagara::core::TelegraphStep step);
    void thrusterGiven(int thruster, double share);

private:
    QWidget* makeThrusters();
    void addDeck();

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    HelmWheel* m_wheel;
    std::vector<ShaftTelegraph*> m_telegraphs;
    std::vector<ThrusterLever*> m_thrusters;
    QWidget* m_thrusterColumn = nullptr;  ///< none without thrusters
    AutopilotPanel* m_autopilot;
    LinePanel* m_lines;
    AnchorPanel* m_anchors;
    BearingList* m_bearings;
    QTabWidget* m_deck;
    QElapsedTimer m_lastOrder;  ///< an order on its way is not undone by the display of the one before
};

}  // namespace sagara::ui::console
