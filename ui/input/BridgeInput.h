#pragma once

#include <QObject>
#include <QPointer>
#include <map>
#include <vector>

#include "core/vessel/Machinery.h"
#include "ui/input/ControlMap.h"
#include "ui/input/Joysticks.h"
#include "ui/input/KeyMap.h"
#include "ui/input/NmeaPort.h"
#include "ui/input/TelegraphLever.h"

class QWidget;

namespace sagara::ui {

/// The ship the controls are for.
struct BridgeShip {
    int shafts = 1;
    double rudderLimit_rad = 0.61;
};

/// Everything with which a person at the bridge gives orders besides the window's own widgets: joysticks,
/// wheels, the keyboard, a home-made bridge by NMEA. One stream of wishes whatever they come from; whoever
/// connects gives the orders. A device that is lost leaves helm and telegraph as they were last ordered.
class BridgeInput final : public QObject {
    Q_OBJECT

public:
    explicit BridgeInput(QObject* parent = nullptr);

    /// Called when a run is opened.
    void setShip(const BridgeShip& ship);
    const BridgeShip& ship() const { return m_ship; }

    /// Keys pressed in its window are orders while it is seen, unless the focus needs them. Null: none.
    void watchKeys(QWidget* window);

    /// While paused everything is read and shown, and nothing is wished: somebody calibrates.
    void setPaused(bool paused);

    Joysticks& joysticks() { return *m_joysticks; }
    NmeaPort& nmea() { return *m_nmea; }
    /// Of a model of device; the usual one when it was never mapped.
    ControlMap mapOf(const JoystickInfo& device) const;
    void setMap(const std::string& model, const ControlMap& map);
    const KeyMap& keys() const { return m_keys; }
    void setKeys(KeyMap keys) { m_keys = std::move(keys); }

    void perform(BridgeAction action, int shaft, bool down);
    /// A bridge that repeats its orders gives them once: what is as it was is no wish.
    void obey(const NmeaOrder& order);

public Q_SLOTS:
    /// What was ordered otherwise (a slider, the pilot), so that steps by key and button begin there.
    void followHelm(double rudder_rad) { m_helm_rad = rudder_rad; }
    void followTelegraph(int shaft, sagara::core::TelegraphStep step);
    void followThruster(double thrust) { m_thrust = thrust; }
    void followSternThruster(double thrust) { m_sternThrust = thrust; }

Q_SIGNALS:
    void helmWanted(double rudder_rad);
    void telegraphWanted(int shaft, sagara::core::TelegraphStep step);  ///< one shaft, counted from port
    void thrusterWanted(double thrust);  ///< at the bow; -1 full to port to 1 full to starboard
    void sternThrusterWanted(double thrust);
    void pitchWanted(int shaft, double pitch);        ///< over the design pitch
    void azimuthWanted(int shaft, double angle_rad);  ///< -pi to pi from ahead, clockwise
    void pitchShiftWanted(int shaft, int steps);      ///< of 5 %, from what it is ordered
    void azimuthShiftWanted(int shaft, int steps);    ///< of 5 degrees
    void hornWanted(bool on);
    void lookWanted(double yaw_radps);  ///< until the next; 0: stop turning
    void acknowledgeWanted();
    void bookmarkWanted();
    void anyActivity();  ///< somebody touched something
    void deviceLost(const QString& name);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    struct AxisState {
        AxisGate gate;
        TelegraphLever lever;
    };
    void connectSources();
    void takeAxis(int id, int axis, double raw);
    void takeButton(int id, int button, bool down);
    void letGo(int id);
    void letGoKeys();
    bool isNew(int what, double value);
    void obeyStep(int engine, core::TelegraphStep step);
    void wantHelm(double rudder_rad);
    void wantStep(int shaft, core::TelegraphStep step);
    template <typename Signal, typename Value>
    void wantOfShafts(int shaft, Signal signal, Value value);
    void shiftStep(int shaft, int steps);
    void wantThruster(double thrust);
    void wantSternThruster(double thrust);

    BridgeShip m_ship;
    Joysticks* m_joysticks;
    NmeaPort* m_nmea;
    QPointer<QWidget> m_window;
    KeyMap m_keys = usualKeys();
    std::map<std::string, ControlMap> m_maps;                ///< by model
    std::map<std::pair<int, int>, AxisState> m_axes;         ///< by device and axis
    std::map<int, std::vector<ButtonMap>> m_held;            ///< by device: what acts while it is held
    std::map<int, std::pair<BridgeAction, int>> m_heldKeys;  ///< by key: Shift may be let go before it
    double m_helm_rad = 0.0;
    double m_thrust = 0.0;
    double m_sternThrust = 0.0;
    std::vector<core::TelegraphStep> m_steps;
    std::map<int, TelegraphLever> m_nmeaLevers;  ///< by engine
    std::map<int, double> m_nmeaLast;            ///< last order of each kind
};

}  // namespace sagara::ui
