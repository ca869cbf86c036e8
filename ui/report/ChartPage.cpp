#include "ui/report/ChartPage.h"

#include "ui/report/Chart.h"
#include "ui/report/ChartFurniture.h"
#include "ui/report/ChartLegend.h"
#include "ui/report/ChartPlan.h"
#include "ui/report/FreeSpot.h"

namespace sagara::report {
namespace {

constexpr double kTitle_mm = 6.0;       ///< line above the chart
constexpr double kLatitudes_mm = 4.5;   ///< to the left of the frame
constexpr double kLongitudes_mm = 5.0;  ///< below the frame
constexpr double kLegend_mm = 33.0;
const TextStyle kTitleStyle{9.0, colour::kInk, true};
const TextStyle kWarningStyle{9.0, colour::kFailed, true};
const TextStyle kInsetStyle{8.0, colour::kInk, true};
const TextStyle kEmptyStyle{10.0, colour::kQuiet};

QRectF chartArea() {
    return page::kContent.adjusted(kLatitudes_mm, kTitle_mm, 0.0, -kLegend_mm - kLongitudes_mm);
}

void drawTitle(QPainter& painter, const RunReport& report, const ChartView& view) {
    const double baseline_mm = page::kTop_mm + 3.4;
    const QString warning = tr("NOT FOR NAVIGATION");
    QString title = report.areaName.empty()
                        ? scaleText(view)
                        : fromStd(report.areaName) + QStringLiteral(" · ") + scaleText(view);
    if (!report.depthDatum.empty())
        title += QStringLiteral(" · ") + tr("depths in metres below %1").arg(fromStd(report.depthDatum));
    title = elided(title, kTitleStyle, page::kTextWidth_mm - width_mm(warning, kWarningStyle) - 4.0);
    drawText(painter, {page::kLeft_mm, baseline_mm}, Qt::AlignLeft, title, kTitleStyle);
    drawText(painter, {page::kRight_mm, baseline_mm}, Qt::AlignRight, warning, kWarningStyle);
}

void drawLayers(Chart& chart) {
    drawSea(chart);
    drawContours(chart);
    drawLand(chart);
    drawGraticule(chart);
    drawCorridor(chart);
    drawOtherTracks(chart);
    drawRoute(chart);
    drawTrack(chart);
    drawMarks(chart);
    drawAnchors(chart);
}

void drawLabels(Chart& chart) {
    labelDeductions(chart);
    labelAnchors(chart);
    labelWaypoints(chart);
    labelTimes(chart);
    labelMarks(chart);
    labelOtherTracks(chart);
    labelContours(chart);
}

void drawFrame(Chart& chart) {
    chart.painter.setBrush(Qt::NoBrush);
    chart.painter.setPen(linePen(colour::kInk, 0.3));
    chart.painter.drawRect(chart.view.frame());
    drawBorderTicks(chart);
    drawGraticuleTexts(chart);
}

/// Everything inside the frame, clipped to it. `furniture`: the box of the scale bar.
void drawChart(Chart& chart, const QRectF& furniture, bool northArrow) {
    chart.painter.save();
    chart.painter.setClipRect(chart.view.frame());
    chart.labels.block(furniture);
    drawLayers(chart);
    const double north_rad = chart.report.frame.convergence_rad(chart.view.centre());
    drawScaleBox(chart.painter, furniture, chart.view, northArrow, north_rad);
    drawLabels(chart);
    chart.painter.restore();
    drawFrame(chart);
}

void drawInset(QPainter& painter, const RunReport& report, const ChartPlan& plan) {
    painter.fillRect(plan.insetBox, colour::kPaper);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(linePen(colour::kInk, 0.2));
    painter.drawRect(plan.insetBox);
    const QString title = tr("Inset: start of the run · %1").arg(scaleText(*plan.inset));
    drawText(painter, plan.insetBox.topLeft() + QPointF(4.5, 3.6), Qt::AlignLeft, title, kInsetStyle);
    Chart chart(painter, *plan.inset, report);
    const QRectF box = freeSpot(plan.inset->frame(), scaleBoxSize_mm(*plan.inset, false),
                                pointsToKeepFree(report, *plan.inset), {});
    drawChart(chart, box, false);
}

/// Where the word "inset" stands over its outline on the main chart.
QRectF insetNameBox(const QRectF& outline) { return {outline.left(), outline.top() - 3.4, 9.0, 3.4}; }

/// What the inset shows, on the main chart.
void drawInsetOutline(QPainter& painter, const QRectF& outline) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(linePen(colour::kInk, 0.25));
    painter.drawRect(outline);
    drawHaloText(painter, outline.topLeft() + QPointF(0.3, -0.8), Qt::AlignLeft, tr("inset"),
                 {6.5, colour::kInk, false, true});
}

void drawMain(QPainter& painter, const RunReport& report, const ChartPlan& plan) {
    Chart chart(painter, plan.main, report);
    chart.shownInInset = plan.insetOnMain;
    std::vector<QRectF> blocked;
    if (plan.inset) blocked = {plan.insetBox, *plan.insetOnMain, insetNameBox(*plan.insetOnMain)};
    for (const QRectF& area : blocked) chart.labels.block(area);
    const QRectF box = freeSpot(plan.main.frame(), scaleBoxSize_mm(plan.main, true),
                                pointsToKeepFree(report, plan.main), blocked);
    drawChart(chart, box, true);
    if (plan.insetOnMain) drawInsetOutline(painter, *plan.insetOnMain);
    if (report.track.empty()) {
        const QPointF at(plan.main.frame().center().x(), plan.main.frame().top() + 12.0);
        drawHaloText(painter, at, Qt::AlignHCenter, tr("No track was recorded."), kEmptyStyle);
    }
}

void drawPage(QPainter& painter, const RunReport& report) {
    const ChartPlan plan = planCharts(report, chartArea());
    drawTitle(painter, report, plan.main);
    drawMain(painter, report, plan);
    if (plan.inset) drawInset(painter, report, plan);
    const QRectF legend(page::kLeft_mm, page::kBottom_mm - kLegend_mm + 1.0, page::kTextWidth_mm, kLegend_mm);
    drawChartLegend(painter, report, legend, outlineInterval_s(Chart(painter, plan.main, report)),
                    plan.inset.has_value());
}

}  // namespace

Sheet chartSheet(const RunReport& report) {
    return {tr("Track chart"), [&report](QPainter& painter) { drawPage(painter, report); }};
}

}  // namespace sagara::report
