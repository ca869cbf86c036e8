#pragma once

#include <QString>

#include "ui/roster/RosterTypes.h"

/// Values of the roster in words.
namespace sagara::ui::roster {

QString dateTime(core::Utc instant);  ///< "22 Nov 2026 14:05", this computer's time
QString dateOnly(core::Utc instant);
QString duration(double time_s);  ///< "12:05", "1:02:05"
QString typeName(const QString& type);
QString statusName(const QString& status);
QString roleName(Role role);
QString stateName(State state);
QString scoreText(double points);  ///< "82", "82.5"
QString passedText(bool passed);

}  // namespace sagara::ui::roster
