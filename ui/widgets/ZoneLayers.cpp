#include <cmath>

#include "ui/chart/AnchorSign.h"
#include "ui/widgets/SceneLayers.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

QColor colourOf(const ChartPalette& palette, ChartZone::Kind kind) {
    switch (kind) {
        case ChartZone::Kind::Done:
            return palette.zoneDone;
        case ChartZone::Kind::Limit:
            return palette.limit;
        case ChartZone::Kind::Task:
            break;
    }
    return palette.zone;
}

/// The place its name is written at.
QPointF placeOfName(const ChartCanvas& canvas, const ChartZone& zone) {
    if (zone.corners.empty())
        return canvas.view.toScreen(zone.centre) - QPointF(0.0, canvas.view.toPixels(zone.radius_m));
    QPointF sum;
    for (const core::NorthEast p : zone.corners) sum += canvas.view.toScreen(p);
    return sum / static_cast<double>(zone.corners.size());
}

void drawZone(ChartCanvas& canvas, const ChartZone& zone) {
    const QColor colour = colourOf(canvas.palette, zone.kind);
    QColor inside = colour;
    inside.setAlpha(zone.corners.size() == 2 ? 0 : zone.kind == ChartZone::Kind::Limit ? 10 : 26);
    canvas.painter.setPen(zone.kind == ChartZone::Kind::Limit ? dashedChartPen(colour, 1.8, 3.0, 3.0)
                                                              : dashedChartPen(colour, 1.8, 8.0, 4.0));
    canvas.painter.setBrush(inside);
    if (zone.corners.empty()) {
        const double r = canvas.view.toPixels(zone.radius_m);
        const QPointF at = canvas.view.toScreen(zone.centre);
        if (canvas.clip().adjusted(-r, -r, r, r).contains(at)) canvas.painter.drawEllipse(at, r, r);
    } else if (zone.corners.size() == 2) {
        canvas.painter.drawLine(canvas.view.toScreen(zone.corners[0]), canvas.view.toScreen(zone.corners[1]));
    } else {
        canvas.painter.drawPolygon(screenRing(canvas.view, zone.corners, canvas.clip()));
    }
}

}  // namespace

void drawZones(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartZone& zone : scene.zones) {
        if (zone.kind != ChartZone::Kind::Limit) drawZone(canvas, zone);
    }
}

/// What must not be entered, and the room to be kept about the own ship.
void drawSafetyLimits(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartZone& zone : scene.zones) {
        if (zone.kind == ChartZone::Kind::Limit) drawZone(canvas, zone);
    }
    if (scene.clearance_m <= 0.0 || scene.ownShips.empty()) return;
    const double r = canvas.view.toPixels(scene.clearance_m);
    canvas.painter.setPen(dashedChartPen(canvas.palette.limit, 1.3, 2.0, 4.0));
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.drawEllipse(canvas.view.toScreen(scene.ownShips.front().position), r, r);
}

void labelZones(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartZone& zone : scene.zones) {
        const bool limit = zone.kind == ChartZone::Kind::Limit;
        if (limit && !canvas.shows(ChartLayer::SafetyLimits)) continue;
        const QPointF at = placeOfName(canvas, zone);
        if (!canvas.frame.contains(at)) continue;
        const QString tick = zone.kind == ChartZone::Kind::Done ? QStringLiteral("✓ ") : QString();
        labelNear(canvas, at, 3.0, 2.0 * canvas.letter_px, {tick + zone.name},
                  canvas.letters(0.85, colourOf(canvas.palette, zone.kind)));
    }
}

void drawAnchors(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartAnchor& anchor : scene.anchors) {
        const QPointF at = canvas.view.toScreen(anchor.position);
        const double r = canvas.view.toPixels(anchor.swing_m);
        canvas.painter.setBrush(Qt::NoBrush);
        canvas.painter.setPen(dashedChartPen(canvas.palette.ownShip, 1.2, 5.0, 4.0));
        if (anchor.swing_m > 0.0) canvas.painter.drawEllipse(at, r, r);
        canvas.painter.setPen(chartPen(canvas.palette.halo, 4.0));
        chart::strokeAnchor(canvas.painter, at, 0.8 * canvas.letter_px);
        canvas.painter.setPen(chartPen(canvas.palette.ownShip, 1.8));
        chart::strokeAnchor(canvas.painter, at, 0.8 * canvas.letter_px);
        canvas.blockAround(at, 0.85 * canvas.letter_px);
    }
}

void labelAnchors(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartAnchor& anchor : scene.anchors) {
        const QPointF at = canvas.view.toScreen(anchor.position);
        if (canvas.frame.contains(at))
            labelNear(canvas, at, canvas.letter_px, 2.0 * canvas.letter_px, {anchor.name},
                      canvas.letters(0.85, canvas.palette.ownShip));
    }
}

}  // namespace sagara::ui
