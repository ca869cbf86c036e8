#include "ui/report/PlotsPage.h"

#include <algorithm>
#include <cmath>

#include "ui/report/Format.h"
#include "ui/report/PlotMoments.h"
#include "ui/report/Text.h"
#include "ui/report/TrackPlots.h"

namespace sagara::report {
namespace {

constexpr double kTickTexts_mm = 11.0;  ///< room for the values to the left of the plots
constexpr double kBetween_mm = 2.2;     ///< from one plot to the next
constexpr double kTimeTexts_mm = 5.0;   ///< below the plots
constexpr double kLegend_mm = 15.0;
const TextStyle kTickStyle{7.5};
const TextStyle kUnitStyle{6.5, colour::kQuiet};
const TextStyle kLegendStyle{7.5};
const TextStyle kEmptyStyle{11.0, colour::kQuiet};

TimeScale timeScale(const RunReport& report) {
    double end_s = 30.0;
    for (const double candidate_s : {report.duration_s, report.track.back().time_s}) {
        if (std::isfinite(candidate_s)) end_s = std::max(end_s, candidate_s);
    }
    return {page::kLeft_mm + kTickTexts_mm, page::kTextWidth_mm - kTickTexts_mm - 1.0, end_s};
}

void drawTimeTexts(QPainter& painter, const TimeScale& time, double y_mm) {
    const double step_s = timeStep_s(time.end_s);
    painter.setPen(linePen(colour::kQuiet, 0.2));
    for (double t_s = 0.0; t_s <= time.end_s + 1e-6; t_s += step_s) {
        const double x_mm = time.x_mm(t_s);
        painter.drawLine(QPointF(x_mm, y_mm), QPointF(x_mm, y_mm + 1.0));
        drawText(painter, {x_mm, y_mm + 3.9}, Qt::AlignHCenter, clockTime(t_s), kTickStyle);
    }
    drawText(painter, {time.left_mm - 4.5, y_mm + 3.9}, Qt::AlignRight, tr("mm:ss"), kUnitStyle);
}

QString taskLegend(const RunReport& report) {
    const std::vector<DoneTask> tasks = doneTasks(report);
    if (tasks.empty()) return report.tasks.empty() ? QString() : tr("No task was done.");
    QStringList parts;
    for (const DoneTask& task : tasks) {
        parts << tr("%1 %2 (%3)").arg(QString::number(task.number), task.title, clockTime(task.time_s));
    }
    return tr("Tasks done, boxes above: %1.").arg(parts.join(QStringLiteral(" · ")));
}

void drawLegend(QPainter& painter, const RunReport& report) {
    QPointF at(page::kLeft_mm, page::kBottom_mm - kLegend_mm + 1.0);
    const TextBlock tasks(taskLegend(report), kLegendStyle, page::kTextWidth_mm, 3);
    tasks.draw(painter, at);
    if (report.deductions.empty()) return;
    at.ry() += tasks.height_mm();
    const QString words = tr("Numbers below the time axis: the deductions of the list, when each began.");
    TextBlock(words, kLegendStyle, page::kTextWidth_mm, 1).draw(painter, at);
}

void drawPlots(QPainter& painter, const RunReport& report) {
    const std::vector<Plot> plots = trackPlots(report);
    const TimeScale time = timeScale(report);
    const TaskBoxes tasks(report, time);
    const double top_mm = page::kTop_mm + tasks.height_mm();
    const double bottom_mm =
        page::kBottom_mm - kLegend_mm - deductionNumbersHeight_mm(report) - kTimeTexts_mm;
    const double pitch_mm = (bottom_mm - top_mm + kBetween_mm) / static_cast<double>(plots.size());
    tasks.draw(painter, page::kTop_mm);
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const double plot_mm = top_mm + static_cast<double>(i) * pitch_mm;
        drawMoments(painter, report, time, plotFrame(time, plot_mm, pitch_mm - kBetween_mm));
        drawPlot(painter, plots[i], time, plot_mm, pitch_mm - kBetween_mm);
    }
    drawTimeTexts(painter, time, bottom_mm);
    drawDeductionNumbers(painter, report, time, bottom_mm + kTimeTexts_mm);
    drawLegend(painter, report);
}

void drawNoTrack(QPainter& painter) {
    drawText(painter, page::kContent.center(), Qt::AlignHCenter,
             tr("No track was recorded: there is nothing to plot."), kEmptyStyle);
}

}  // namespace

Sheet plotsSheet(const RunReport& report) {
    return {tr("Plots over time"), [&report](QPainter& painter) {
                report.track.empty() ? drawNoTrack(painter) : drawPlots(painter, report);
            }};
}

}  // namespace sagara::report
