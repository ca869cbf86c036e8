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
class DriveControls;
class HelmWheel;
class LinePanel;
class ThrusterLever;

/// What is worked from the bridge: telegraphs with pitch and azimuth, wheel, thrusters, autopilot, deck.
/// Follows what others order.
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
    void setPitch(int shaft, double pitch);  ///< over the design pitch
    void setAzimuth(int shaft, double angle_rad);
    void shiftPitch(int shaft, int steps);  ///< as by the mouse wheel
    void shiftAzimuth(int shaft, int steps);
    void turnHelmBy(double rudder_rad);
    void midships();
    void moveTelegraphs(int steps);

Q_SIGNALS:
    /// Whoever gave it: for input devices that have to follow.
    void helmGiven(double rudder_rad);
    void telegraphGiven(int shaft, sagara::core::TelegraphStep step);
    void thrusterGiven(int thruster, double share);

private:
    QWidget* addDrive(std::size_t i);
    QWidget* makeThrusters();
    void addDeck();
    void give(core::Order order);
    DriveControls* drive(int shaft);  ///< null: no such shaft

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    HelmWheel* m_wheel;
    std::vector<DriveControls*> m_drives;  ///< port to starboard
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
