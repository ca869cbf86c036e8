#include <cmath>

#include "core/base/Units.h"
#include "ui/widgets/SceneLayers.h"
#include "ui/widgets/ShipShape.h"

namespace sagara::ui {
namespace {

constexpr double kStill_mps = 0.05;  ///< slower than this has no vector

QPolygonF outlineOnScreen(const ChartCanvas& canvas, const ChartShip& ship) {
    QPolygonF polygon;
    for (const core::NorthEast p : shipOutline(ship.position, ship.heading_rad, ship.length_m, ship.beam_m))
        polygon << canvas.view.toScreen(p);
    return polygon;
}

/// Unit vector on the screen towards a direction of frame N.
QPointF towards(const ChartCanvas& canvas, double direction_rad) {
    const core::NorthEast d = core::unitVector(direction_rad - canvas.view.up_rad());
    return {d.east_m, -d.north_m};
}

/// Where she will be after each minute if nothing changes; a tick at each when there is room.
void drawVector(ChartCanvas& canvas, const ChartShip& ship, double minutes, const QPen& pen) {
    if (core::length(ship.overGround_mps) < kStill_mps || minutes <= 0.0) return;
    const QPointF from = canvas.view.toScreen(ship.position);
    const QPointF to = canvas.view.toScreen(ship.position + (60.0 * minutes) * ship.overGround_mps);
    canvas.painter.setPen(pen);
    canvas.painter.drawLine(from, to);
    const QPointF along = to - from;
    const double length_px = std::hypot(along.x(), along.y());
    if (length_px < 1.0) return;
    for (double way = 10.0; way < std::min(length_px, 300.0); way += 12.0)
        canvas.labels.avoid(from + (way / length_px) * along);
    const QPointF across = 3.5 / length_px * QPointF(-along.y(), along.x());
    QPen solid = pen;
    solid.setStyle(Qt::SolidLine);
    canvas.painter.setPen(solid);
    if (length_px / minutes >= 12.0) {
        for (double minute = 1.0; minute < minutes; ++minute) {
            const QPointF at = from + along * (minute / minutes);
            canvas.painter.drawLine(at - across, at + across);
        }
    }
    const QPointF back = 7.0 / length_px * along;
    canvas.painter.drawPolyline(QPolygonF{to - back + across, to, to - back - across});
}

/// The triangle of radar and AIS: its tip is where she heads.
QPolygonF triangle(const ChartCanvas& canvas, const ChartShip& ship) {
    const double size = 0.62 * canvas.letter_px;
    const QPointF at = canvas.view.toScreen(ship.position), ahead = towards(canvas, ship.heading_rad);
    const QPointF right(-ahead.y(), ahead.x());
    return {at + 1.25 * size * ahead, at - 0.75 * size * ahead + 0.62 * size * right,
            at - 0.75 * size * ahead - 0.62 * size * right};
}

void drawTarget(ChartCanvas& canvas, const ChartShip& ship, double minutes) {
    const QColor colour = ship.hostile ? canvas.palette.hostile : canvas.palette.target;
    if (canvas.shows(ChartLayer::Vectors))
        drawVector(canvas, ship, minutes, dashedChartPen(colour, 1.5, 6.0, 3.0));
    const bool toScale = drawnToScale(canvas.view, ship.length_m, canvas.letter_px);
    canvas.painter.setPen(chartPen(colour, ship.hostile ? 2.2 : 1.6));
    canvas.painter.setBrush(ship.hostile ? QBrush(colour) : QBrush(canvas.palette.hull));
    canvas.painter.drawPolygon(toScale ? outlineOnScreen(canvas, ship) : triangle(canvas, ship));
}

/// Two rings, her heading and her beam: as an ECDIS shows the own ship when she is too small to scale.
void drawOwnSymbol(ChartCanvas& canvas, const ChartShip& ship) {
    const QPointF at = canvas.view.toScreen(ship.position), ahead = towards(canvas, ship.heading_rad);
    const QPointF right(-ahead.y(), ahead.x());
    const double r = 0.55 * canvas.letter_px;
    canvas.painter.setPen(chartPen(canvas.palette.ownShip, 1.6));
    canvas.painter.setBrush(canvas.palette.hull);
    canvas.painter.drawEllipse(at, r, r);
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.drawEllipse(at, 0.5 * r, 0.5 * r);
    canvas.painter.drawLine(at, at + 3.6 * r * ahead);
    canvas.painter.drawLine(at - 1.6 * r * right, at + 1.6 * r * right);
}

void drawOwnShip(ChartCanvas& canvas, const ChartShip& ship, double minutes) {
    if (canvas.shows(ChartLayer::Vectors))
        drawVector(canvas, ship, minutes, chartPen(canvas.palette.ownShip, 1.6));
    if (!drawnToScale(canvas.view, ship.length_m, canvas.letter_px)) {
        drawOwnSymbol(canvas, ship);
        return;
    }
    canvas.painter.setPen(chartPen(canvas.palette.ownShip, 2.0));
    canvas.painter.setBrush(canvas.palette.hull);
    canvas.painter.drawPolygon(outlineOnScreen(canvas, ship));
    const QPointF at = canvas.view.toScreen(ship.position), ahead = towards(canvas, ship.heading_rad);
    const double half_px = 0.5 * canvas.view.toPixels(ship.length_m);
    canvas.painter.setPen(chartPen(canvas.palette.ownShip, 1.2));
    canvas.painter.drawLine(at + half_px * ahead, at + (half_px + 1.2 * canvas.letter_px) * ahead);
    canvas.painter.drawLine(at - 3.0 * ahead, at + 3.0 * ahead);
    const QPointF right(-ahead.y(), ahead.x());
    canvas.painter.drawLine(at - 3.0 * right, at + 3.0 * right);
}

/// Half the room a ship takes up on the screen.
double half_px(const ChartCanvas& canvas, const ChartShip& ship) {
    return drawnToScale(canvas.view, ship.length_m, canvas.letter_px)
               ? 0.5 * canvas.view.toPixels(ship.beam_m) + 2.0
               : 0.8 * canvas.letter_px;
}

void labelShip(ChartCanvas& canvas, const ChartShip& ship, const QColor& colour, bool bold) {
    const QPointF at = canvas.view.toScreen(ship.position);
    if (!canvas.frame.contains(at)) return;
    Lettering letters = canvas.letters(0.92, colour);
    letters.bold = bold;
    labelNear(canvas, at, half_px(canvas, ship) + 0.2 * canvas.letter_px, 2.5 * canvas.letter_px, {ship.name},
              letters);
}

}  // namespace

void drawTargets(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartShip& ship : scene.targets) {
        if (!canvas.holds(canvas.view.toScreen(ship.position))) continue;
        drawTarget(canvas, ship, scene.vector_min);
        canvas.blockAround(canvas.view.toScreen(ship.position), half_px(canvas, ship));
    }
}

void drawOwnShips(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartShip& ship : scene.ownShips) {
        drawOwnShip(canvas, ship, scene.vector_min);
        canvas.blockAround(canvas.view.toScreen(ship.position), half_px(canvas, ship));
    }
}

void labelShips(ChartCanvas& canvas, const ChartScene& scene) {
    if (canvas.shows(ChartLayer::OwnShips)) {
        for (const ChartShip& ship : scene.ownShips) labelShip(canvas, ship, canvas.palette.ownShip, true);
    }
    if (!canvas.shows(ChartLayer::Targets)) return;
    for (const bool hostile : {true, false}) {
        for (const ChartShip& ship : scene.targets) {
            if (ship.hostile == hostile)
                labelShip(canvas, ship, hostile ? canvas.palette.hostile : canvas.palette.target, hostile);
        }
    }
}

}  // namespace sagara::ui
