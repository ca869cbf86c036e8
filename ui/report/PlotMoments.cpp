#include "ui/report/PlotMoments.h"

#include <algorithm>
#include <cmath>

#include "ui/report/Format.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kBox_mm = 4.0;  ///< height of a task's box, and its least width
constexpr double kBoxRow_mm = 4.6;
constexpr double kBelowBoxes_mm = 1.2;
constexpr double kDeductionRow_mm = 3.0;
constexpr std::size_t kDeductionRows = 3;
const TextStyle kTaskStyle{7.5, colour::kNavy, true};
const TextStyle kDeductionStyle{7.0, colour::kFailed, true};

}  // namespace

std::vector<DoneTask> doneTasks(const RunReport& report) {
    std::vector<DoneTask> done;
    int number = 0;
    for (const TaskLine& task : report.tasks) {
        ++number;
        if (task.done && std::isfinite(task.time_s))
            done.push_back({number, task.time_s, fromStd(task.title)});
    }
    return done;
}

TaskBoxes::TaskBoxes(const RunReport& report, const TimeScale& time) : m_tasks(doneTasks(report)) {
    std::vector<double> x_mm;
    for (const DoneTask& task : m_tasks) x_mm.push_back(time.x_mm(task.time_s));
    m_markers =
        arrangeMarkers(x_mm, 2, [this](const std::vector<int>& places) { return width(places) + 0.4; });
}

QString TaskBoxes::words(const std::vector<int>& places) const {
    std::vector<int> numbers;
    for (const int place : places) numbers.push_back(m_tasks[static_cast<std::size_t>(place - 1)].number);
    std::sort(numbers.begin(), numbers.end());
    return ranges(numbers);
}

double TaskBoxes::width(const std::vector<int>& places) const {
    return std::max(kBox_mm, width_mm(words(places), kTaskStyle) + 1.8);
}

double TaskBoxes::height_mm() const {
    std::size_t rows = 1;
    for (const Marker& marker : m_markers) rows = std::max(rows, marker.row + 1);
    return kBoxRow_mm * static_cast<double>(rows) + kBelowBoxes_mm;
}

void TaskBoxes::drawBox(QPainter& painter, const Marker& marker, double top_mm) const {
    const double wide_mm = width(marker.numbers);
    const double left_mm = std::min(marker.x_mm - 0.5 * wide_mm, page::kRight_mm - wide_mm);
    const double bottom_mm =
        top_mm + height_mm() - kBelowBoxes_mm - kBoxRow_mm * static_cast<double>(marker.row);
    const QRectF box(left_mm, bottom_mm - kBox_mm, wide_mm, kBox_mm);
    painter.setPen(linePen(colour::kNavy, 0.2));
    painter.setBrush(colour::kPaper);
    painter.drawRect(box);
    drawText(painter, box.center(), Qt::AlignHCenter | Qt::AlignVCenter, words(marker.numbers), kTaskStyle);
}

void TaskBoxes::draw(QPainter& painter, double top_mm) const {
    for (const Marker& marker : m_markers) drawBox(painter, marker, top_mm);
}

void drawMoments(QPainter& painter, const RunReport& report, const TimeScale& time, const QRectF& frame) {
    painter.setPen(linePen(colour::kNavy, 0.16));
    for (const DoneTask& task : doneTasks(report)) {
        const double x_mm = time.x_mm(task.time_s);
        painter.drawLine(QPointF(x_mm, frame.top()), QPointF(x_mm, frame.bottom()));
    }
    painter.setPen(linePen(colour::kFailed, 0.35));
    for (const DeductionLine& line : report.deductions) {
        const double x_mm = time.x_mm(line.time_s);
        painter.drawLine(QPointF(x_mm, frame.bottom() - 1.6), QPointF(x_mm, frame.bottom()));
    }
}

double deductionNumbersHeight_mm(const RunReport& report) {
    return report.deductions.empty() ? 0.0 : kDeductionRow_mm * static_cast<double>(kDeductionRows) + 1.0;
}

void drawDeductionNumbers(QPainter& painter, const RunReport& report, const TimeScale& time, double top_mm) {
    std::vector<double> x_mm;
    for (const DeductionLine& line : report.deductions) x_mm.push_back(time.x_mm(line.time_s));
    const auto widthOf = [](const std::vector<int>& numbers) {
        return width_mm(ranges(numbers), kDeductionStyle) + 0.9;
    };
    for (const Marker& marker : arrangeMarkers(x_mm, kDeductionRows, widthOf)) {
        const double y_mm = top_mm + kDeductionRow_mm * (static_cast<double>(marker.row) + 0.9);
        drawText(painter, {marker.x_mm, y_mm}, Qt::AlignHCenter, ranges(marker.numbers), kDeductionStyle);
    }
}

}  // namespace sagara::report
