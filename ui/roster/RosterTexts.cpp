#include "ui/roster/RosterTexts.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <cmath>

namespace sagara::ui::roster {
namespace {

QString text(const char* source) { return QCoreApplication::translate("roster", source); }

QString shown(core::Utc instant, const QString& format) {
    return QLocale(QLocale::English).toString(QDateTime::fromSecsSinceEpoch(instant.unix_s), format);
}

}  // namespace

QString dateTime(core::Utc instant) { return shown(instant, QStringLiteral("d MMM yyyy HH:mm")); }
QString dateOnly(core::Utc instant) { return shown(instant, QStringLiteral("d MMM yyyy")); }

QString duration(double time_s) {
    const auto whole = static_cast<qint64>(std::isfinite(time_s) && time_s > 0.0 ? time_s : 0.0);
    const QString rest = QStringLiteral("%1:%2")
                             .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
                             .arg(whole % 60, 2, 10, QLatin1Char('0'));
    return whole < 3600 ? rest : QString::number(whole / 3600) + QLatin1Char(':') + rest;
}

QString typeName(const QString& type) {
    if (type == QLatin1String("familiarise")) return text("Familiarisation");
    if (type == QLatin1String("train")) return text("Training");
    if (type == QLatin1String("assess")) return text("Assessment");
    if (type == QLatin1String("self-study")) return text("Self-study");
    if (type == QLatin1String("demo")) return text("Demonstration");
    return type;
}

QString statusName(const QString& status) {
    if (status == QLatin1String("running")) return text("under way");
    if (status == QLatin1String("finished")) return text("finished");
    if (status == QLatin1String("aborted")) return text("broken off");
    return status;
}

QString roleName(Role role) {
    switch (role) {
        case Role::Trainee:
            return text("Trainee");
        case Role::Trainer:
            return text("Trainer");
        case Role::Admin:
            return text("Administrator");
    }
    return {};
}

QString stateName(State state) {
    switch (state) {
        case State::Open:
            return text("open");
        case State::Done:
            return text("done");
        case State::Late:
            return text("late");
        case State::Withdrawn:
            return text("withdrawn");
    }
    return {};
}

QString scoreText(double points) {
    const QString digits = QString::number(points, 'f', 1);
    return digits.endsWith(QLatin1String(".0")) ? digits.chopped(2) : digits;
}

QString passedText(bool passed) { return passed ? text("passed") : text("not passed"); }

}  // namespace sagara::ui::roster
