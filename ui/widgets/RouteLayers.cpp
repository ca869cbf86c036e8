#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Corridor.h"
#include "ui/chart/Format.h"
#include "ui/widgets/SceneLayers.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

constexpr double kStep_px = 9.0;

/// All pieces as one shape, filled once, so that the band is equally pale where pieces overlap. Every piece
/// runs the same way round; in a bend tighter than its limit some would otherwise cut holes.
QPainterPath bandShape(const ChartCanvas& canvas, const ChartScene& scene) {
    QPainterPath shape;
    shape.setFillRule(Qt::WindingFill);
    const QRectF clip = canvas.clip();
    for (const chart::CorridorPiece& piece :
         chart::corridorPieces(scene.route, scene.path, canvas.view.toMetres(kStep_px))) {
        QPolygonF corners;
        for (const core::NorthEast corner : piece.corners) corners << canvas.view.toScreen(corner);
        if (!corners.boundingRect().intersects(clip)) continue;
        const QPointF a = corners[2] - corners[0], b = corners[3] - corners[1];
        if (a.x() * b.y() - a.y() * b.x() < 0.0) std::reverse(corners.begin(), corners.end());
        shape.addPolygon(corners);
        shape.closeSubpath();
    }
    return shape;
}

void drawLine(ChartCanvas& canvas, std::span<const core::NorthEast> line) {
    for (const QPolygonF& piece : screenPieces(canvas.view, line, canvas.clip()))
        canvas.painter.drawPolyline(piece);
}

double waypoint_px(const ChartCanvas& canvas) { return 0.42 * canvas.letter_px; }

/// "183° 0.41 M" beside the middle of a leg that is long enough for it.
void labelLeg(ChartCanvas& canvas, core::NorthEast from, core::NorthEast to) {
    const QPointF a = canvas.view.toScreen(from), b = canvas.view.toScreen(to), along = b - a;
    const double length_px = std::hypot(along.x(), along.y());
    const Lettering letters = canvas.letters(0.82, canvas.palette.route);
    const QString words =
        QStringLiteral("%1°T %2 M").arg(chart::bearing(core::bearing_rad(from, to) / core::kDegree_rad),
                                        chart::number(core::distance(from, to) / core::kNauticalMile_m, 2));
    const double width_px = textWidth_px(words, letters);
    if (length_px < width_px + 3.0 * canvas.letter_px) return;
    double turned_deg = std::atan2(along.y(), along.x()) / core::kDegree_rad;
    if (std::abs(turned_deg) > 90.0) turned_deg += 180.0;
    const double turned_rad = turned_deg * core::kDegree_rad;
    const QPointF above = 0.75 * canvas.letter_px * QPointF(std::sin(turned_rad), -std::cos(turned_rad));
    const QPointF at = 0.5 * (a + b) + above;
    const QTransform turn = QTransform().translate(at.x(), at.y()).rotate(turned_deg);
    const QRectF box =
        turn.mapRect(QRectF(-0.5 * width_px, -0.5 * letters.size_px, width_px, letters.size_px));
    if (!canvas.labels.isFree(box)) return;
    canvas.labels.block(box);
    drawText(canvas.painter, at, Qt::AlignHCenter | Qt::AlignVCenter, words, letters, turned_deg);
}

QString waypointText(std::size_t i, const core::Route::Waypoint& waypoint) {
    const QString number = QString::number(i + 1);
    return waypoint.name.empty() ? number : number + u' ' + QString::fromStdString(waypoint.name);
}

}  // namespace

void drawRoute(ChartCanvas& canvas, const ChartScene& scene) {
    if (scene.path.length_m() > 0.0) {
        canvas.painter.fillPath(bandShape(canvas, scene), canvas.palette.corridor);
        canvas.painter.setBrush(Qt::NoBrush);
        canvas.painter.setPen(chartPen(canvas.palette.route, 0.8));
        const double step_m = canvas.view.toMetres(kStep_px);
        for (const double side : {-1.0, 1.0}) {
            for (const auto& line : chart::corridorEdge(scene.route, scene.path, side, step_m))
                drawLine(canvas, line);
        }
        canvas.painter.setPen(dashedChartPen(canvas.palette.route, 1.8, 9.0, 4.0));
        drawLine(canvas, chart::pathLine(scene.path, step_m));
    }
    for (const core::Route::Waypoint& waypoint : scene.route.waypoints) {
        const QPointF at = canvas.view.toScreen(waypoint.position);
        if (!canvas.holds(at)) continue;
        canvas.painter.setPen(chartPen(canvas.palette.route, 1.8));
        canvas.painter.setBrush(canvas.palette.hull);
        canvas.painter.drawEllipse(at, waypoint_px(canvas), waypoint_px(canvas));
        canvas.blockAround(at, waypoint_px(canvas));
    }
}

void labelRoute(ChartCanvas& canvas, const ChartScene& scene) {
    const auto& waypoints = scene.route.waypoints;
    Lettering letters = canvas.letters(0.88, canvas.palette.route);
    letters.bold = true;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
        const QPointF at = canvas.view.toScreen(waypoints[i].position);
        if (!canvas.frame.contains(at)) continue;
        const double gap = waypoint_px(canvas) + 0.25 * canvas.letter_px;
        if (!labelNear(canvas, at, gap, 2.0 * canvas.letter_px, {waypointText(i, waypoints[i])}, letters))
            labelNear(canvas, at, gap, 3.0 * canvas.letter_px, {QString::number(i + 1)}, letters);
    }
    for (std::size_t i = 1; i < waypoints.size(); ++i)
        labelLeg(canvas, waypoints[i - 1].position, waypoints[i].position);
}

}  // namespace sagara::ui
