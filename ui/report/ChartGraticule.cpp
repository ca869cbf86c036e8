#include <QPolygonF>
#include <vector>

#include "ui/chart/Graticule.h"
#include "ui/report/Chart.h"
#include "ui/report/Format.h"

namespace sagara::report {
namespace {

constexpr double kLeastSpacing_mm = 34.0;
const TextStyle kTextStyle{6.5, colour::kInk};

using chart::GridLine;

/// Distance of the lines in minutes of arc.
double step_min(const ChartView& view) { return chart::graticuleStep_min(view.toMetres(kLeastSpacing_mm)); }

std::vector<GridLine> parallels(const Chart& chart, double ofStep = 1.0) {
    return chart::parallels(chart.report.frame, chart.view.extent(), ofStep * step_min(chart.view));
}

std::vector<GridLine> meridians(const Chart& chart, double ofStep = 1.0) {
    return chart::meridians(chart.report.frame, chart.view.extent(), ofStep * step_min(chart.view));
}

int decimals(const ChartView& view) { return step_min(view) < 0.0999 ? 2 : 1; }

}  // namespace

void drawGraticule(Chart& chart) {
    chart.painter.setPen(linePen(colour::kRule, 0.1));
    for (const GridLine& line : parallels(chart))
        chart.painter.drawLine(chart.view.toPage(line.from), chart.view.toPage(line.to));
    for (const GridLine& line : meridians(chart))
        chart.painter.drawLine(chart.view.toPage(line.from), chart.view.toPage(line.to));
}

/// Ticks on the inside of the border, five to a line of the graticule.
void drawBorderTicks(Chart& chart) {
    constexpr double kTick_mm = 1.2;
    const QRectF& frame = chart.view.frame();
    chart.painter.setPen(linePen(colour::kInk, 0.15));
    for (const GridLine& line : parallels(chart, 0.2)) {
        const double y_mm = chart.view.toPage(line.from).y();
        chart.painter.drawLine(QPointF(frame.left(), y_mm), QPointF(frame.left() + kTick_mm, y_mm));
        chart.painter.drawLine(QPointF(frame.right(), y_mm), QPointF(frame.right() - kTick_mm, y_mm));
    }
    for (const GridLine& line : meridians(chart, 0.2)) {
        const double x_mm = chart.view.toPage(line.from).x();
        chart.painter.drawLine(QPointF(x_mm, frame.top()), QPointF(x_mm, frame.top() + kTick_mm));
        chart.painter.drawLine(QPointF(x_mm, frame.bottom()), QPointF(x_mm, frame.bottom() - kTick_mm));
    }
}

void drawGraticuleTexts(Chart& chart) {
    const QRectF& frame = chart.view.frame();
    for (const GridLine& line : parallels(chart)) {
        const double y_mm = chart.view.toPage(line.from).y();
        const QString words = latitude(line.value_deg, decimals(chart.view));
        if (y_mm < frame.top() + 9.0 || y_mm > frame.bottom() - 9.0) continue;
        drawText(chart.painter, {frame.left() - 1.2, y_mm}, Qt::AlignHCenter, words, kTextStyle, -90.0);
    }
    for (const GridLine& line : meridians(chart)) {
        const double x_mm = chart.view.toPage(line.from).x();
        if (x_mm < frame.left() + 9.0 || x_mm > frame.right() - 9.0) continue;
        drawText(chart.painter, {x_mm, frame.bottom() + 3.2}, Qt::AlignHCenter,
                 longitude(line.value_deg, decimals(chart.view)), kTextStyle);
    }
}

}  // namespace sagara::report
