#include "ui/hints/HintTexts.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"

namespace sagara::ui {
namespace {

constexpr double kCable_m = core::kNauticalMile_m / 10.0;
constexpr double kTooFast_mps = 0.1 * core::kKnot_mps;  // as the rubric: the display has one decimal

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::Hints", text); }

HintLine waypointLine(const Hints::Waypoint& next) {
    QString detail =
        tr("%1°T, %2")
            .arg(chart::bearing(next.bearing_rad / core::kDegree_rad), hintDistance(next.distance_m));
    if (next.time_s) detail += tr(", %1").arg(hintDuration(*next.time_s));
    return {tr("Next waypoint"), QString::fromStdString(next.name), detail, false};
}

HintLine trackLine(const Hints::OffTrack& track) {
    const QString side = track.off_m < 0.0 ? tr("to port of the track") : tr("to starboard of the track");
    return {tr("Cross-track"), tr("%1 %2").arg(hintDistance(std::abs(track.off_m)), side),
            track.outside() ? tr("outside the corridor of %1").arg(hintDistance(track.limit_m))
                            : tr("corridor %1").arg(hintDistance(track.limit_m)),
            track.outside()};
}

}  // namespace

QString hintDistance(double distance_m) {
    if (distance_m < 2.0 * kCable_m) return tr("%1 m").arg(std::round(distance_m), 0, 'f', 0);
    return tr("%1 M").arg(distance_m / core::kNauticalMile_m, 0, 'f', 2);
}

QString hintDuration(double time_s) {
    const auto minutes = static_cast<long>(std::lround(time_s / 60.0));
    if (minutes < 1) return tr("under 1 min");
    if (minutes < 60) return tr("%1 min").arg(minutes);
    return tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

QString hintSpeed(double speed_mps) {
    return tr("%1 kn").arg(chart::shortNumber(speed_mps / core::kKnot_mps, 1));
}

QVector<HintLine> hintLines(const Hints& hints, double speed_mps) {
    QVector<HintLine> lines;
    if (hints.task) {
        lines.append({tr("Task %1 of %2").arg(hints.task->number).arg(hints.task->of),
                      QString::fromStdString(hints.task->title),
                      {},
                      false});
    } else if (hints.allDone) {
        lines.append({tr("Tasks"), tr("All done"), {}, false});
    }
    if (hints.waypoint) lines.append(waypointLine(*hints.waypoint));
    if (hints.speedLimit_mps && *hints.speedLimit_mps < 59.0 * core::kKnot_mps) {
        const bool tooFast = speed_mps > *hints.speedLimit_mps + kTooFast_mps;
        lines.append({tr("Speed allowed here"), hintSpeed(*hints.speedLimit_mps),
                      tooFast ? tr("she makes %1: slow down").arg(hintSpeed(speed_mps)) : QString(),
                      tooFast});
    }
    if (hints.ahead) {
        const bool soon = speed_mps > hints.ahead->limit_mps && hints.ahead->in_m < 3.0 * kCable_m;
        lines.append({tr("Speed limit ahead"), hintSpeed(hints.ahead->limit_mps),
                      tr("in %1").arg(hintDistance(hints.ahead->in_m)), soon});
    }
    if (hints.track) lines.append(trackLine(*hints.track));
    return lines;
}

}  // namespace sagara::ui
