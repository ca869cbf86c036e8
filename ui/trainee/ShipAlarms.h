#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace sagara::ui::console {

/// What the alarm panel of the ship is wired to: sensors of her own, nothing a trainer knows.
struct AlarmInputs {
    double time_s = 0.0;
    std::optional<double> underKeel_m;
    double depthAlarm_m = 0.0;
    std::optional<double> offCourse_rad;  ///< of the autopilot's heading; none when it does not steer
    std::vector<bool> enginesStopped;     ///< shut down by themselves
    std::vector<bool> thrustersStopped;
    int steeringPumpsStopped = 0;
    double rudderBehind_rad = 0.0;  ///< order less rudder, while the rudder does not move
    bool lineParted = false;
    bool cableParted = false;
    bool aground = false;
};

struct Alarm {
    QString id;
    QString text;
    bool active = true;  ///< else it has passed and waits to be acknowledged
    bool acknowledged = false;
};

/// The alarms of a bridge: each comes once, sounds until it is acknowledged, stays in sight until its cause
/// is gone. No clock, no widget.
class ShipAlarms {
public:
    void update(const AlarmInputs& now);
    void acknowledgeAll();
    /// Whether the buzzer is to be heard.
    bool sounding() const;
    /// The newest first.
    const std::vector<Alarm>& list() const { return m_alarms; }

private:
    void set(const QString& id, const QString& text, bool active);
    bool lasting(const QString& id, bool now, double time_s, double for_s);

    std::vector<Alarm> m_alarms;
    struct Since {
        QString id;
        double time_s;
    };
    std::vector<Since> m_since;
};

}  // namespace sagara::ui::console
