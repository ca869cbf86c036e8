#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/SceneLayers.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

constexpr double kNamesTo = 26000.0;  ///< denominator up to which waypoints are named, not only numbered

/// All pieces as one shape, filled once, so that the band is equally pale where pieces overlap. Every piece
/// runs the same way round; in a bend tighter than its limit some would otherwise cut holes.
QPainterPath bandPath(const ChartCanvas& canvas, const RouteShape& route) {
    QPainterPath shape;
    shape.setFillRule(Qt::WindingFill);
    const QRectF clip = canvas.clip();
    for (const chart::CorridorPiece& piece : route.band) {
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

/// "183° 0.41 M" beside a leg that is long enough for it, on the side where nothing is.
void labelLeg(ChartCanvas& canvas, const core::LocalFrame& frame, core::NorthEast from, core::NorthEast to) {
    const QPointF a = canvas.view.toScreen(from), b = canvas.view.toScreen(to), along = b - a;
    const double length_px = std::hypot(along.x(), along.y());
    const Lettering letters = canvas.letters(0.82, canvas.palette.route);
    const RangeBearing leg = measure(frame, from, to);
    const QString words = tr("%1 %2 M").arg(bearingText(leg.bearing_rad),
                                            chart::number(leg.distance_m / core::kNauticalMile_m, 2));
    const double width_px = textWidth_px(words, letters);
    if (length_px < width_px + 3.0 * canvas.letter_px) return;
    double turned_deg = std::atan2(along.y(), along.x()) / core::kDegree_rad;
    if (std::abs(turned_deg) > 90.0) turned_deg += 180.0;
    const double turned_rad = turned_deg * core::kDegree_rad;
    const QPointF beside = 1.1 * canvas.letter_px * QPointF(std::sin(turned_rad), -std::cos(turned_rad));
    for (const auto& [part, side] : std::array<std::array<double, 2>, 6>{
             {{0.5, 1.0}, {0.5, -1.0}, {0.35, 1.0}, {0.35, -1.0}, {0.65, 1.0}, {0.65, -1.0}}}) {
        const QPointF at = a + part * along + side * beside;
        const QTransform turn = QTransform().translate(at.x(), at.y()).rotate(turned_deg);
        const QRectF box =
            turn.mapRect(QRectF(-0.5 * width_px, -0.5 * letters.size_px, width_px, letters.size_px));
        if (!canvas.frame.contains(at) || !canvas.labels.isClear(box)) continue;
        canvas.labels.block(box);
        drawText(canvas.painter, at, Qt::AlignHCenter | Qt::AlignVCenter, words, letters, turned_deg);
        return;
    }
}

QString waypointText(std::size_t i, const core::Route::Waypoint& waypoint) {
    const QString number = QString::number(i + 1);
    return waypoint.name.empty() ? number : number + u' ' + QString::fromStdString(waypoint.name);
}

}  // namespace

double routeStep_m(const ChartTransform& view) { return view.toMetres(9.0); }

void drawRoute(ChartCanvas& canvas, const ChartScene& scene, const RouteShape& shape) {
    canvas.painter.fillPath(bandPath(canvas, shape), canvas.palette.corridor);
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(chartPen(canvas.palette.route, 1.0));
    for (const auto& edge : shape.edges) drawLine(canvas, edge);
    canvas.painter.setPen(dashedChartPen(canvas.palette.route, 1.8, 9.0, 4.0));
    drawLine(canvas, shape.line);
    for (const core::Route::Waypoint& waypoint : scene.route.waypoints) {
        const QPointF at = canvas.view.toScreen(waypoint.position);
        if (!canvas.holds(at)) continue;
        canvas.painter.setPen(chartPen(canvas.palette.route, 1.8));
        canvas.painter.setBrush(canvas.palette.hull);
        canvas.painter.drawEllipse(at, waypoint_px(canvas), waypoint_px(canvas));
        canvas.blockAround(at, waypoint_px(canvas));
    }
}

void labelRoute(ChartCanvas& canvas, const ChartScene& scene, const core::LocalFrame& frame) {
    const auto& waypoints = scene.route.waypoints;
    Lettering letters = canvas.letters(0.88, canvas.palette.route);
    letters.bold = true;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
        const QPointF at = canvas.view.toScreen(waypoints[i].position);
        if (!canvas.frame.contains(at)) continue;
        const double gap = waypoint_px(canvas) + 0.25 * canvas.letter_px;
        const bool named =
            canvas.denominator <= kNamesTo &&
            labelNear(canvas, at, gap, 2.0 * canvas.letter_px, {waypointText(i, waypoints[i])}, letters);
        if (!named) labelNear(canvas, at, gap, 3.0 * canvas.letter_px, {QString::number(i + 1)}, letters);
    }
    for (std::size_t i = 1; i < waypoints.size(); ++i)
        labelLeg(canvas, frame, waypoints[i - 1].position, waypoints[i].position);
}

}  // namespace sagara::ui
