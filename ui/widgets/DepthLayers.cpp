#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Shapes.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

QColor colourOf(const ChartPalette& palette, PreparedChart::DepthArea::Shade shade) {
    using Shade = PreparedChart::DepthArea::Shade;
    switch (shade) {
        case Shade::Shallow:
            return palette.shallow;
        case Shade::Unsafe:
            return palette.unsafe;
        case Shade::Safe:
            return palette.safe;
        case Shade::Deep:
            break;
    }
    return palette.deep;
}

QPainterPath pathOf(const ChartCanvas& canvas, const std::vector<ChartLine>& rings) {
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    const chart::Extent shown = canvas.view.extent();
    for (const ChartLine& ring : rings) {
        if (!meets(ring.box, shown)) continue;
        const QPolygonF polygon = screenRing(canvas.view, ring.points, canvas.clip());
        if (polygon.size() > 2) path.addPolygon(polygon);
    }
    return path;
}

bool onLand(const ChartCanvas& canvas, const PreparedChart& chart, QPointF p) {
    const core::NorthEast place = canvas.view.toChart(p);
    return chart.area->isLand(place) ||
           std::any_of(chart.context.begin(), chart.context.end(),
                       [&](const ChartLine& ring) { return core::contains(ring.points, place); });
}

/// Along its line, over a gap, never upside down.
void drawContourText(ChartCanvas& canvas, const QPolygonF& line, qsizetype i, const QString& depth,
                     const Lettering& letters) {
    const QPointF along = line[std::min(i + 1, line.size() - 1)] - line[std::max<qsizetype>(i - 1, 0)];
    double turned_deg = std::atan2(along.y(), along.x()) / core::kDegree_rad;
    if (std::abs(turned_deg) > 90.0) turned_deg += 180.0;
    drawText(canvas.painter, line[i], Qt::AlignHCenter | Qt::AlignVCenter, depth, letters, turned_deg);
}

void labelContour(ChartCanvas& canvas, const PreparedChart& chart, const QPolygonF& line,
                  const QString& depth, const Lettering& letters) {
    const double apart = 26.0 * canvas.letter_px;
    const double side = std::max(textWidth_px(depth, letters), letters.size_px) + 4.0;
    double since = 0.75 * apart;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF step = line[i] - line[i - 1];
        since += std::hypot(step.x(), step.y());
        if (since < apart) continue;
        const QRectF box(line[i].x() - 0.5 * side, line[i].y() - 0.5 * side, side, side);
        if (!canvas.labels.isFree(box) || onLand(canvas, chart, line[i])) continue;
        canvas.labels.block(box);
        drawContourText(canvas, line, i, depth, letters);
        since = 0.0;
    }
}

}  // namespace

/// Without smoothing: where two grids meet, smoothed edges would show as a seam. Contours smooth the steps.
void drawDepthAreas(ChartCanvas& canvas, const PreparedChart& chart) {
    QPainter& painter = canvas.painter;
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const PreparedChart::GridAreas& grid : chart.grids) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(canvas.palette.drying);
        painter.drawPolygon(screenRing(canvas.view, grid.border, canvas.clip()));
        for (const auto& depths : grid.depths) {
            painter.fillPath(pathOf(canvas, depths.rings), colourOf(canvas.palette, depths.shade));
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void drawDepthLimit(ChartCanvas& canvas, const PreparedChart& chart) {
    if (chart.grids.empty()) return;
    const auto& border = chart.grids.front().border;
    const Lettering letters = canvas.letters(0.82, canvas.palette.quiet);
    for (std::size_t i = 0; i < border.size(); ++i) {
        const std::array<core::NorthEast, 2> side{border[i], border[(i + 1) % border.size()]};
        canvas.painter.setPen(dashedChartPen(canvas.palette.quiet, 1.0, 8.0, 5.0));
        for (const QPolygonF& piece : screenPieces(canvas.view, side, canvas.clip()))
            canvas.painter.drawPolyline(piece);
        const core::NorthEast outward =
            core::unitVector(core::bearing_rad(side[0], side[1]) - 0.5 * core::kPi);
        if (i % 2 == 1) continue;  // beside the western and the eastern side there is room for words
        for (const double part : {0.35, 0.15, 0.6, 0.85}) {
            const core::NorthEast p =
                side[0] + part * (side[1] - side[0]) + canvas.view.toMetres(10.0) * outward;
            const QPointF at = canvas.view.toScreen(p);
            if (!canvas.frame.contains(at) || onLand(canvas, chart, at)) continue;
            labelNear(canvas, at, 2.0, 3.0 * canvas.letter_px, {tr("no depths beyond")}, letters);
            break;
        }
    }
}

void drawContours(ChartCanvas& canvas, const PreparedChart& chart) {
    const chart::Extent shown = canvas.view.extent();
    canvas.painter.setBrush(Qt::NoBrush);
    for (const auto& contour : chart.contours) {
        canvas.painter.setPen(contour.safety ? chartPen(canvas.palette.safetyContour, 2.2)
                                             : chartPen(canvas.palette.contour, 1.0));
        for (const ChartLine& line : contour.lines) {
            if (!meets(line.box, shown)) continue;
            for (const QPolygonF& piece : screenPieces(canvas.view, line.points, canvas.clip()))
                canvas.painter.drawPolyline(piece);
        }
    }
}

void labelContours(ChartCanvas& canvas, const PreparedChart& chart) {
    const chart::Extent shown = canvas.view.extent();
    for (auto contour = chart.contours.rbegin(); contour != chart.contours.rend(); ++contour) {
        Lettering letters = canvas.letters(0.85, canvas.palette.quiet);
        letters.bold = contour->safety;
        letters.italic = true;
        const QString depth = chart::shortNumber(contour->depth_m, 1);
        for (const ChartLine& line : contour->lines) {
            if (!meets(line.box, shown)) continue;
            for (const QPolygonF& piece : screenPieces(canvas.view, line.points, canvas.clip()))
                labelContour(canvas, chart, piece, depth, letters);
        }
    }
}

}  // namespace sagara::ui
