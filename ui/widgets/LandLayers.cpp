#include <QPainterPath>

#include "ui/chart/Graticule.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/GraticuleStep.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

void drawRings(ChartCanvas& canvas, const std::vector<ChartLine>& rings, const QPen& outline) {
    const chart::Extent shown = canvas.view.extent();
    for (const ChartLine& ring : rings) {
        if (!meets(ring.box, shown)) continue;
        const QPolygonF polygon = screenRing(canvas.view, ring.points, canvas.clip());
        canvas.painter.setPen(outline);
        canvas.painter.setBrush(canvas.palette.land);
        canvas.painter.drawPolygon(polygon);
    }
}

}  // namespace

/// The coarse land far out first: where the fine one is, it covers it.
void drawLand(ChartCanvas& canvas, const PreparedChart& chart) {
    drawRings(canvas, chart.context, QPen(Qt::NoPen));
    drawRings(canvas, chart.land, chartPen(canvas.palette.shore, 1.2));
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(chartPen(canvas.palette.quay, 1.8));
    for (const ChartLine& shore : chart.shores) {
        for (const QPolygonF& piece : screenPieces(canvas.view, shore.points, canvas.clip()))
            canvas.painter.drawPolyline(piece);
    }
}

void drawGraticule(ChartCanvas& canvas, const PreparedChart& chart) {
    const core::LocalFrame& frame = chart.area->frame;
    const chart::Extent shown = canvas.view.extent();
    const double step_min = graticuleStep_min(canvas.view, canvas.letter_px);
    canvas.painter.setPen(chartPen(canvas.palette.graticule, 1.0));
    for (const chart::GridLine& line : chart::parallels(frame, shown, step_min))
        canvas.painter.drawLine(canvas.view.toScreen(line.from), canvas.view.toScreen(line.to));
    for (const chart::GridLine& line : chart::meridians(frame, shown, step_min))
        canvas.painter.drawLine(canvas.view.toScreen(line.from), canvas.view.toScreen(line.to));
}

}  // namespace sagara::ui
