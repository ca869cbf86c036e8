#include <algorithm>

#include "ui/chart/Corridor.h"
#include "ui/report/Chart.h"
#include "ui/report/ChartSigns.h"

namespace sagara::report {
namespace {

constexpr double kStep_mm = 1.0;
constexpr double kWaypoint_mm = 1.1;  ///< radius of its ring
const TextStyle kNameStyle{7.0, colour::kRoute, true};

/// All pieces as one shape that is filled once, so that the band is equally pale where pieces overlap. Every
/// piece runs the same way round; in a bend tighter than its limit some would otherwise cut holes.
QPainterPath bandShape(const Chart& chart) {
    QPainterPath shape;
    shape.setFillRule(Qt::WindingFill);
    for (const chart::CorridorPiece& piece :
         chart::corridorPieces(chart.report.route, chart.report.path, chart.view.toMetres(kStep_mm))) {
        QPolygonF corners = chart.view.toPage(piece.corners);
        const QPointF a = corners[2] - corners[0], b = corners[3] - corners[1];
        if (a.x() * b.y() - a.y() * b.x() < 0.0) std::reverse(corners.begin(), corners.end());
        shape.addPolygon(corners);
        shape.closeSubpath();
    }
    return shape;
}

void drawEdge(Chart& chart, double side, const QPen& pen) {
    chart.painter.setPen(pen);
    for (const auto& line :
         chart::corridorEdge(chart.report.route, chart.report.path, side, chart.view.toMetres(kStep_mm))) {
        chart.painter.drawPolyline(chart.view.toPage(line));
    }
}

QString waypointText(std::size_t i, const core::Route::Waypoint& waypoint) {
    const QString number = QString::number(i + 1);
    return waypoint.name.empty() ? number : number + QLatin1Char(' ') + fromStd(waypoint.name);
}

}  // namespace

void drawCorridor(Chart& chart) {
    chart.painter.setPen(Qt::NoPen);
    chart.painter.setBrush(colour::kCorridor);
    chart.painter.drawPath(bandShape(chart));
    chart.painter.setBrush(Qt::NoBrush);
    drawEdge(chart, -1.0, corridorEdgePen());
    drawEdge(chart, 1.0, corridorEdgePen());
}

void drawRoute(Chart& chart) {
    const QPolygonF line =
        chart.view.toPage(chart::pathLine(chart.report.path, chart.view.toMetres(kStep_mm)));
    chart.painter.setBrush(Qt::NoBrush);
    chart.painter.setPen(routePen());
    chart.painter.drawPolyline(line);
    for (const QPointF& p : line) chart.labels.avoid(p);
    for (const core::Route::Waypoint& waypoint : chart.report.route.waypoints) {
        const QPointF at = chart.view.toPage(waypoint.position);
        drawWaypointSign(chart.painter, at, kWaypoint_mm);
        chart.labels.block(
            QRectF(at.x() - kWaypoint_mm, at.y() - kWaypoint_mm, 2.0 * kWaypoint_mm, 2.0 * kWaypoint_mm));
    }
}

void labelWaypoints(Chart& chart) {
    const auto& waypoints = chart.report.route.waypoints;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
        if (!chart.details(waypoints[i].position)) continue;
        labelNear(chart, chart.view.toPage(waypoints[i].position), kWaypoint_mm + 0.5, 18.0,
                  waypointText(i, waypoints[i]), kNameStyle);
    }
}

}  // namespace sagara::report
