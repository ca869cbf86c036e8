#include "ui/trainee/ShipAlarms.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui::console {
namespace {

constexpr double kOffCourse_rad = 10.0 * core::kDegree_rad, kOffCourse_s = 5.0;
constexpr double kRudderBehind_rad = 3.0 * core::kDegree_rad, kRudderBehind_s = 6.0;

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::console::ShipAlarms", text); }

}  // namespace

void ShipAlarms::update(const AlarmInputs& now) {
    const bool shallow = now.underKeel_m && *now.underKeel_m < now.depthAlarm_m;
    set(QStringLiteral("aground"), tr("Aground"), now.aground);
    set(QStringLiteral("shallow"), tr("Shallow water"), shallow);
    set(QStringLiteral("off-course"), tr("Off course"),
        lasting(QStringLiteral("off-course"),
                now.offCourse_rad && std::abs(*now.offCourse_rad) > kOffCourse_rad, now.time_s,
                kOffCourse_s));
    for (std::size_t i = 0; i < now.enginesStopped.size(); ++i)
        set(QStringLiteral("engine-%1").arg(i), tr("Main engine %1 shut down").arg(i + 1),
            now.enginesStopped[i]);
    for (std::size_t i = 0; i < now.thrustersStopped.size(); ++i)
        set(QStringLiteral("thruster-%1").arg(i), tr("Thruster %1 shut down").arg(i + 1),
            now.thrustersStopped[i]);
    set(QStringLiteral("steering-pump"),
        now.steeringPumpsStopped > 1 ? tr("Both steering pumps stopped") : tr("Steering pump stopped"),
        now.steeringPumpsStopped > 0);
    set(QStringLiteral("rudder"), tr("Rudder does not follow the order"),
        lasting(QStringLiteral("rudder"), std::abs(now.rudderBehind_rad) > kRudderBehind_rad, now.time_s,
                kRudderBehind_s));
    set(QStringLiteral("line"), tr("A mooring line has parted"), now.lineParted);
    set(QStringLiteral("cable"), tr("An anchor cable has parted"), now.cableParted);
    std::erase_if(m_alarms, [](const Alarm& a) { return !a.active && a.acknowledged; });
}

bool ShipAlarms::lasting(const QString& id, bool now, double time_s, double for_s) {
    const auto at = std::find_if(m_since.begin(), m_since.end(), [&](const Since& s) { return s.id == id; });
    if (!now) {
        if (at != m_since.end()) m_since.erase(at);
        return false;
    }
    if (at == m_since.end()) {
        m_since.push_back({id, time_s});
        return false;
    }
    return time_s - at->time_s >= for_s;
}

void ShipAlarms::set(const QString& id, const QString& text, bool active) {
    const auto at =
        std::find_if(m_alarms.begin(), m_alarms.end(), [&](const Alarm& a) { return a.id == id; });
    if (at == m_alarms.end()) {
        if (active) m_alarms.insert(m_alarms.begin(), {id, text});
        return;
    }
    if (active && !at->active) at->acknowledged = false;  // it comes again
    at->active = active;
    if (active) at->text = text;
}

void ShipAlarms::acknowledgeAll() {
    for (Alarm& alarm : m_alarms) alarm.acknowledged = true;
    std::erase_if(m_alarms, [](const Alarm& a) { return !a.active; });
}

bool ShipAlarms::sounding() const {
    return std::any_of(m_alarms.begin(), m_alarms.end(), [](const Alarm& a) { return !a.acknowledged; });
}

}  // namespace sagara::ui::console
