#include "ui/chart/Graticule.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/GraticuleStep.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

void fillRings(ChartCanvas& canvas, const std::vector<ChartLine>& rings) {
    const chart::Extent shown = canvas.view.extent();
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(canvas.palette.land);
    for (const ChartLine& ring : rings) {
        if (meets(ring.box, shown))
            canvas.painter.drawPolygon(screenRing(canvas.view, ring.points, canvas.clip()));
    }
}

void drawShore(ChartCanvas& canvas, const std::vector<ChartLine>& lines, const QPen& pen) {
    const chart::Extent shown = canvas.view.extent();
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(pen);
    for (const ChartLine& line : lines) {
        if (!meets(line.box, shown)) continue;
        for (const QPolygonF& piece : screenPieces(canvas.view, line.points, canvas.clip()))
            canvas.painter.drawPolyline(piece);
    }
}

}  // namespace

/// The coarse land far out first: where the fine one is, it covers it. Only shore has a line: where a ring is
/// cut off at the edge of the area there is none.
void drawLand(ChartCanvas& canvas, const PreparedChart& chart) {
    fillRings(canvas, chart.context);
    fillRings(canvas, chart.land);
    drawShore(canvas, chart.coast, chartPen(canvas.palette.shore, 1.3));
    drawShore(canvas, chart.stone, chartPen(canvas.palette.quay, 1.8));
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
