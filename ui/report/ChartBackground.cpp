#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "core/base/Shapes.h"
#include "core/base/Units.h"
#include "ui/chart/Polyline.h"
#include "ui/report/Chart.h"
#include "ui/report/Format.h"

namespace sagara::report {
namespace {

constexpr double kFine_mm = 0.05;  ///< detail that no printer shows
const TextStyle kContourStyle{6.0, colour::kContourText, false, true};

/// Whether any part of a line may lie in the frame.
bool touches(const ChartView& view, const QPolygonF& line) {
    return line.boundingRect().adjusted(-0.1, -0.1, 0.1, 0.1).intersects(view.frame());
}

QPolygonF pageLine(const ChartView& view, std::span<const core::NorthEast> line) {
    return view.toPage(chart::simplified(line, view.toMetres(kFine_mm)));
}

/// A text of a contour lies along its line, over a gap, never upside down.
void drawDepthText(Chart& chart, const QPolygonF& line, qsizetype at, const QString& depth) {
    const QPointF along = line[std::min(at + 1, line.size() - 1)] - line[std::max<qsizetype>(at - 1, 0)];
    double turned_deg = std::atan2(along.y(), along.x()) / core::kDegree_rad;
    if (std::abs(turned_deg) > 90.0) turned_deg += 180.0;
    drawHaloText(chart.painter, line[at], Qt::AlignHCenter | Qt::AlignVCenter, depth, kContourStyle,
                 turned_deg);
}

/// Contours run on under the land, where the depth grid goes through zero.
bool onLand(const Chart& chart, QPointF p) {
    const core::NorthEast place = chart.view.toChart(p);
    return std::any_of(chart.report.land.begin(), chart.report.land.end(),
                       [&](const auto& ring) { return ring.size() > 2 && core::contains(ring, place); });
}

/// Labels a contour at the first free points of it, no nearer to each other than a hand's breadth.
void labelContour(Chart& chart, const QPolygonF& line, const QString& depth) {
    const QSizeF size(width_mm(depth, kContourStyle) + 1.6, 2.8);
    constexpr double kApart_mm = 55.0, kShortest_mm = 14.0;
    double since_mm = kApart_mm - kShortest_mm;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF step = line[i] - line[i - 1];
        since_mm += std::hypot(step.x(), step.y());
        QRectF box(QPointF(), size);
        box.moveCenter(line[i]);
        if (since_mm < kApart_mm || !chart.labels.isFree(box) || onLand(chart, line[i])) continue;
        chart.labels.block(box);
        drawDepthText(chart, line, i, depth);
        since_mm = 0.0;
    }
}

}  // namespace

void drawSea(Chart& chart) { chart.painter.fillRect(chart.view.frame(), colour::kWater); }

void drawContours(Chart& chart) {
    chart.painter.setBrush(Qt::NoBrush);
    for (const Contour& contour : chart.report.contours) {
        chart.painter.setPen(linePen(colour::kContour, contour.depth_m <= 5.0 ? 0.25 : 0.16));
        for (const auto& line : contour.lines) {
            const QPolygonF polygon = pageLine(chart.view, line);
            if (touches(chart.view, polygon)) chart.painter.drawPolyline(polygon);
        }
    }
}

void drawLand(Chart& chart) {
    chart.painter.setPen(linePen(colour::kShore, 0.22));
    chart.painter.setBrush(colour::kLand);
    for (const auto& ring : chart.report.land) {
        const QPolygonF polygon = pageLine(chart.view, ring);
        if (touches(chart.view, polygon)) chart.painter.drawPolygon(polygon);
    }
}

void labelContours(Chart& chart) {
    for (const Contour& contour : chart.report.contours) {
        for (const auto& line : contour.lines) {
            const QPolygonF polygon = pageLine(chart.view, line);
            if (touches(chart.view, polygon)) labelContour(chart, polygon, shortNumber(contour.depth_m, 1));
        }
    }
}

}  // namespace sagara::report
