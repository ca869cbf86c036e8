#include <algorithm>
#include <cmath>

#include "ui/chart/Polyline.h"
#include "ui/report/Chart.h"
#include "ui/report/ChartSigns.h"
#include "ui/report/Format.h"
#include "ui/report/TrackMoments.h"

namespace sagara::report {
namespace {

constexpr double kTick_mm = 1.1;       ///< half of its length
constexpr double kLeastShip_mm = 1.2;  ///< a shorter ship is a dot
const TextStyle kTimeStyle{6.5, colour::kInk};

std::vector<core::NorthEast> positions(const std::vector<TrackPoint>& track) {
    std::vector<core::NorthEast> line;
    for (const TrackPoint& p : track) line.push_back(p.position);
    return line;
}

/// A ship seen from above: flat stern, straight sides, pointed bow.
QPolygonF hull(const Chart& chart, const TrackPoint& point) {
    const double x = 0.5 * chart.report.shipLength_m, y = 0.5 * chart.report.shipBeam_m;
    const core::HeadingFrame ship(point.position, point.heading_rad);
    QPolygonF outline;
    for (const core::BodyPoint p :
         {core::BodyPoint{-x, -0.85 * y}, core::BodyPoint{-0.2 * x, -y}, core::BodyPoint{0.4 * x, -0.9 * y},
          core::BodyPoint{0.75 * x, -0.5 * y}, core::BodyPoint{x, 0.0}, core::BodyPoint{0.75 * x, 0.5 * y},
          core::BodyPoint{0.4 * x, 0.9 * y}, core::BodyPoint{-0.2 * x, y}, core::BodyPoint{-x, 0.85 * y}}) {
        outline << chart.view.toPage(ship.point(p));
    }
    return outline;
}

void drawOutlines(Chart& chart) {
    const auto& track = chart.report.track;
    if (chart.view.toMm(chart.report.shipLength_m) < kLeastShip_mm) return;
    chart.painter.setPen(linePen(colour::kInk, 0.12));
    chart.painter.setBrush(colour::kHull);
    for (const std::size_t i : outlineMoments(track, outlineInterval_s(chart), chart.report.shipLength_m)) {
        if (chart.details(track[i].position)) chart.painter.drawPolygon(hull(chart, track[i]));
    }
}

/// Moments of the time ticks that lie on the same spot, as a ship at rest has them, together.
struct TimeTick {
    std::size_t point = 0;
    double first_s = 0.0;
    double last_s = 0.0;
};

std::vector<TimeTick> timeTicks(const Chart& chart) {
    const auto& track = chart.report.track;
    std::vector<TimeTick> ticks;
    if (track.empty()) return ticks;
    const double interval_s = tickInterval_s(track);
    for (double t_s = 0.0; t_s <= track.back().time_s; t_s += interval_s) {
        const std::optional<std::size_t> i = pointAtTime(track, t_s);
        if (!i) continue;
        const bool same = !ticks.empty() && chart.view.toMm(core::distance(track[ticks.back().point].position,
                                                                           track[*i].position)) < 2.0;
        if (same) {
            ticks.back().last_s = t_s;
        } else {
            ticks.push_back({*i, t_s, t_s});
        }
    }
    return ticks;
}

/// Direction of the track on the page at a point, a unit vector; along the heading for a ship at rest.
QPointF directionAt(const std::vector<TrackPoint>& track, std::size_t i) {
    const std::size_t before = i >= 2 ? i - 2 : 0, after = std::min(i + 2, track.size() - 1);
    core::NorthEast way = track[after].position - track[before].position;
    if (core::length(way) < 0.5) way = core::unitVector(track[i].heading_rad);
    way = (1.0 / core::length(way)) * way;
    return {way.east_m, -way.north_m};
}

void drawTick(Chart& chart, const TimeTick& tick) {
    const QPointF at = chart.view.toPage(chart.report.track[tick.point].position);
    const QPointF along = directionAt(chart.report.track, tick.point);
    const QPointF across = kTick_mm * QPointF(-along.y(), along.x());
    chart.painter.setPen(tickPen());
    chart.painter.drawLine(at - across, at + across);
}

}  // namespace

double outlineInterval_s(const Chart& chart) {
    const double apart_m = std::max(1.5 * chart.report.shipLength_m, chart.view.toMetres(3.0));
    return outlineInterval_s(chart.report.track, apart_m);
}

void drawTrack(Chart& chart) {
    if (chart.report.track.empty()) return;
    const QPolygonF line =
        chart.view.toPage(chart::simplified(positions(chart.report.track), chart.view.toMetres(0.03)));
    chart.painter.setBrush(Qt::NoBrush);
    chart.painter.setPen(trackPen());
    chart.painter.drawPolyline(line);
    if (line.size() == 1) chart.painter.drawEllipse(line.first(), 0.6, 0.6);
    drawOutlines(chart);
    for (const TimeTick& tick : timeTicks(chart)) drawTick(chart, tick);
    // every millimetre or so, labels keep off
    QPointF last(-1e9, -1e9);
    for (const TrackPoint& point : chart.report.track) {
        const QPointF p = chart.view.toPage(point.position);
        if (std::hypot(p.x() - last.x(), p.y() - last.y()) < 1.0) continue;
        chart.labels.avoid(last = p);
    }
}

void labelTimes(Chart& chart) {
    for (const TimeTick& tick : timeTicks(chart)) {
        const core::NorthEast place = chart.report.track[tick.point].position;
        if (!chart.details(place)) continue;
        QString words = clockTime(tick.first_s);
        if (tick.last_s > tick.first_s) words += QChar(0x2013) + clockTime(tick.last_s);
        labelNear(chart, chart.view.toPage(place), kTick_mm + 0.4, 9.0, words, kTimeStyle);
    }
}

}  // namespace sagara::report
