#include "ui/chart/Marks.h"
#include "ui/report/Chart.h"

namespace sagara::report {
namespace {

constexpr double kSize_mm = 2.6;
const TextStyle kRealStyle{6.0, colour::kInk};
const TextStyle kFictionalStyle{6.0, colour::kInk, false, true};

/// Fictional names are in italics, which the legend explains; the word itself would fill the chart.
QString markText(const ChartMark& mark) {
    QString name = fromStd(mark.name);
    if (mark.fictional) name.remove(QStringLiteral("(fictional)"));
    return name.simplified();
}

}  // namespace

void drawMarks(Chart& chart) {
    for (const ChartMark& mark : chart.report.marks) {
        const QPointF at = chart.view.toPage(mark.position);
        if (!chart.view.frame().contains(at)) continue;
        drawMark(chart.painter, at, mark, kSize_mm);
        chart.labels.block(QRectF(at.x() - 0.5 * kSize_mm, at.y() - 0.5 * kSize_mm, kSize_mm, kSize_mm));
    }
}

void labelMarks(Chart& chart) {
    for (const ChartMark& mark : chart.report.marks) {
        if (!chart.details(mark.position)) continue;
        labelNear(chart, chart.view.toPage(mark.position), 0.5 * kSize_mm + 0.7, 8.0, markText(mark),
                  mark.fictional ? kFictionalStyle : kRealStyle);
    }
}

}  // namespace sagara::report
