#include "ui/report/PlotsPage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/report/Format.h"
#include "ui/report/MarkerRows.h"
#include "ui/report/Text.h"
#include "ui/report/TrackPlots.h"

namespace sagara::report {
namespace {

constexpr double kTickTexts_mm = 11.0;  ///< room for the values to the left of the plots
constexpr double kTaskStrip_mm = 5.8;   ///< above the plots: numbers of the tasks
constexpr double kBetween_mm = 2.2;     ///< from one plot to the next
constexpr double kTimeTexts_mm = 5.0;   ///< below the plots
constexpr double kDeductionRow_mm = 3.0;
constexpr std::size_t kDeductionRows = 3;
constexpr double kLegend_mm = 15.0;
const TextStyle kTickStyle{7.5};
const TextStyle kTaskStyle{7.5, colour::kNavy, true};
const TextStyle kDeductionStyle{7.0, colour::kFailed, true};
const TextStyle kLegendStyle{7.5, colour::kInk};
const TextStyle kEmptyStyle{11.0, colour::kQuiet};

struct DoneTask {
    int number = 0;
    double time_s = 0.0;
    QString title;
};

std::vector<DoneTask> doneTasks(const RunReport& report) {
    std::vector<DoneTask> done;
    int number = 0;
    for (const TaskLine& task : report.tasks) {
        ++number;
        if (task.done) done.push_back({number, task.time_s, fromStd(task.title)});
    }
    return done;
}

QPen taskPen() { return linePen(colour::kNavy, 0.16); }

TimeScale timeScale(const RunReport& report) {
    double end_s = std::max(report.duration_s, report.track.empty() ? 0.0 : report.track.back().time_s);
    if (!std::isfinite(end_s)) end_s = 0.0;
    return {page::kLeft_mm + kTickTexts_mm, page::kTextWidth_mm - kTickTexts_mm - 1.0, std::max(end_s, 30.0)};
}

/// Numbers of the tasks in boxes above the plots, pushed apart where they are close.
void drawTaskNumbers(QPainter& painter, const std::vector<DoneTask>& tasks, const TimeScale& time) {
    constexpr double kBox_mm = 4.0;
    double free_mm = time.left_mm;
    for (const DoneTask& task : tasks) {
        const QString number = QString::number(task.number);
        const double wide_mm = std::max(kBox_mm, width_mm(number, kTaskStyle) + 1.6);
        const double left_mm = std::clamp(time.x_mm(task.time_s) - 0.5 * wide_mm, free_mm,
                                          std::max(free_mm, time.right_mm() - wide_mm));
        const QRectF box(left_mm, page::kTop_mm, wide_mm, kBox_mm);
        painter.setPen(taskPen());
        painter.drawLine(QPointF(box.center().x(), box.bottom()),
                         QPointF(time.x_mm(task.time_s), box.bottom() + 1.4));
        painter.setPen(linePen(colour::kNavy, 0.2));
        painter.setBrush(colour::kPaper);
        painter.drawRect(box);
        drawText(painter, box.center(), Qt::AlignHCenter | Qt::AlignVCenter, number, kTaskStyle);
        free_mm = left_mm + wide_mm + 0.8;
    }
}

/// In one plot: a thin line for every task done and a short red tick for every deduction.
void drawMoments(QPainter& painter, const RunReport& report, const TimeScale& time, const QRectF& frame) {
    painter.setPen(taskPen());
    for (const DoneTask& task : doneTasks(report)) {
        painter.drawLine(QPointF(time.x_mm(task.time_s), frame.top()),
                         QPointF(time.x_mm(task.time_s), frame.bottom()));
    }
    painter.setPen(linePen(colour::kFailed, 0.35));
    for (const DeductionLine& line : report.deductions) {
        const double x_mm = time.x_mm(line.time_s);
        painter.drawLine(QPointF(x_mm, frame.bottom() - 1.6), QPointF(x_mm, frame.bottom()));
    }
}

void drawTimeTexts(QPainter& painter, const TimeScale& time, double y_mm) {
    const double step_s = timeStep_s(time.end_s);
    painter.setPen(linePen(colour::kQuiet, 0.2));
    for (double t_s = 0.0; t_s <= time.end_s + 1e-6; t_s += step_s) {
        const double x_mm = time.x_mm(t_s);
        painter.drawLine(QPointF(x_mm, y_mm), QPointF(x_mm, y_mm + 1.0));
        drawText(painter, {x_mm, y_mm + 3.9}, Qt::AlignHCenter, clockTime(t_s), kTickStyle);
    }
    drawText(painter, {time.left_mm - 4.5, y_mm + 3.9}, Qt::AlignRight, tr("mm:ss"),
             TextStyle{6.5, colour::kQuiet});
}

/// The numbers of the deductions below the time axis.
void drawDeductionNumbers(QPainter& painter, const RunReport& report, const TimeScale& time, double top_mm) {
    std::vector<double> x_mm;
    for (const DeductionLine& line : report.deductions) x_mm.push_back(time.x_mm(line.time_s));
    for (const Marker& marker :
         arrangeMarkers(x_mm, kDeductionRows, width_mm(QStringLiteral("00"), kDeductionStyle))) {
        const double y_mm = top_mm + kDeductionRow_mm * (static_cast<double>(marker.row) + 0.9);
        drawText(painter, {marker.x_mm, y_mm}, Qt::AlignHCenter, ranges(marker.numbers), kDeductionStyle);
    }
}

QString legend(const RunReport& report, const std::vector<DoneTask>& tasks) {
    QStringList parts;
    for (const DoneTask& task : tasks) {
        parts << tr("%1 %2 (%3)").arg(task.number).arg(task.title, clockTime(task.time_s));
    }
    QString words = tasks.empty() ? tr("No task was done.")
                                  : tr("Tasks done, boxes above: %1.").arg(parts.join(QStringLiteral(" · ")));
    if (!report.deductions.empty())
        words += QLatin1Char('\n') +
                 tr("Red numbers below the time axis: the deductions of the list, when each began.");
    return words;
}

void drawPlots(QPainter& painter, const RunReport& report) {
    const std::vector<Plot> plots = trackPlots(report);
    const TimeScale time = timeScale(report);
    const double deductions_mm = report.deductions.empty() ? 0.0 : kDeductionRow_mm * kDeductionRows + 1.0;
    const double bottom_mm = page::kBottom_mm - kLegend_mm - deductions_mm - kTimeTexts_mm;
    const double first_mm = page::kTop_mm + kTaskStrip_mm;
    const double pitch_mm = (bottom_mm - first_mm + kBetween_mm) / static_cast<double>(plots.size());
    const std::vector<DoneTask> tasks = doneTasks(report);
    drawTaskNumbers(painter, tasks, time);
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const double top_mm = first_mm + static_cast<double>(i) * pitch_mm;
        drawMoments(painter, report, time, plotFrame(time, top_mm, pitch_mm - kBetween_mm));
        drawPlot(painter, plots[i], time, top_mm, pitch_mm - kBetween_mm);
    }
    drawTimeTexts(painter, time, bottom_mm);
    drawDeductionNumbers(painter, report, time, bottom_mm + kTimeTexts_mm);
    const TextBlock words(legend(report, tasks), kLegendStyle, page::kTextWidth_mm, 4);
    words.draw(painter, {page::kLeft_mm, page::kBottom_mm - kLegend_mm + 1.0});
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
