#include "ui/widgets/ChartTexts.h"

#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"
#include "ui/widgets/AreaTexts.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {
namespace {

QString cutOff(double depth_m) { return chart::number(std::floor(10.0 * depth_m + 1e-6) / 10.0, 1); }

}  // namespace

QString positionText(const core::LocalFrame& frame, core::NorthEast p) {
    const core::GeoPoint geo = frame.toGeo(p);
    return chart::latitude(geo.lat_deg, 2) + u' ' + chart::longitude(geo.lon_deg, 2);
}

QString bearingText(double bearing_rad) {
    return chart::bearing(bearing_rad / core::kDegree_rad) + QStringLiteral("°T");
}

QString distanceText(double distance_m) {
    return tr("%1 M %2 cables")
        .arg(chart::number(distance_m / core::kNauticalMile_m, 2),
             chart::number(distance_m / core::kCable_m, 1));
}

QString rangeBearingText(const RangeBearing& measured) {
    return bearingText(measured.bearing_rad) + u' ' + distanceText(measured.distance_m);
}

QString depthText(const PreparedChart& chart, core::NorthEast p) {
    if (!chart.area) return tr("no depth");
    if (chart.area->isLand(p)) return tr("land");
    if (!chart.hasDepth(p)) return tr("no depth");
    const double depth_m = chart.area->depth_m(p);
    if (depth_m < 0.0) return tr("dries %1 m").arg(chart::number(-depth_m, 1));
    return tr("%1 m").arg(cutOff(depth_m));
}

QString speedText(double speed_mps) { return tr("%1 kn").arg(chart::number(speed_mps / core::kKnot_mps, 1)); }

QString clockText(double timeOfDay_s) {
    if (!std::isfinite(timeOfDay_s)) return QStringLiteral("–");
    const long long minutes = (std::llround(std::floor(timeOfDay_s / 60.0)) % 1440 + 1440) % 1440;
    return QStringLiteral("%1:%2")
        .arg(minutes / 60, 2, 10, QLatin1Char('0'))
        .arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

QString shipText(const core::LocalFrame& frame, const ChartShip& ship) {
    const double speed_mps = core::length(ship.overGround_mps);
    QString text = ship.name;
    text +=
        u'\n' + tr("heading %1").arg(bearingText(trueDirection_rad(frame, ship.position, ship.heading_rad)));
    if (speed_mps >= 0.05) {
        const double course_rad = core::bearing_rad({}, ship.overGround_mps);
        text += u'\n' + tr("over ground %1 %2")
                            .arg(bearingText(trueDirection_rad(frame, ship.position, course_rad)),
                                 speedText(speed_mps));
    }
    text += u'\n' + tr("%1 m long, %2 m wide")
                        .arg(chart::shortNumber(ship.length_m, 1), chart::shortNumber(ship.beam_m, 1));
    return text;
}

QString markText(const core::Mark& mark) {
    QString text = QString::fromStdString(mark.name);
    if (mark.light) text += u'\n' + lightText(*mark.light);
    return text;
}

QString berthText(const core::Berth& berth, const QString& datum) {
    return QString::fromStdString(berth.name) + u'\n' +
           tr("depth alongside %1 m below %2").arg(chart::number(berth.depth_m, 1), datum);
}

QString depthNote(const core::Area& area) {
    const QString datum = QString::fromStdString(area.depthDatum);
    const QString depths = depthsAreModelled(area) ? tr("Modelled depths in metres below %1. Source: %2.")
                                                   : tr("Depths in metres below %1. Source: %2.");
    QString source = QString::fromStdString(area.depthSource);
    if (source.startsWith(QStringLiteral("modelled:"))) source = source.mid(9).trimmed();
    return depths.arg(datum, source);
}

}  // namespace sagara::ui
