#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <vector>

#include "ui/report/MarkerRows.h"
#include "ui/report/ReportData.h"
#include "ui/report/TimePlot.h"

/// Tasks and deductions at their moments on the time axis of the plots.
namespace sagara::report {

struct DoneTask {
    int number = 0;  ///< of the list of tasks
    double time_s = 0.0;
    QString title;
};
std::vector<DoneTask> doneTasks(const RunReport& report);

/// Boxes with the numbers of the tasks done, in one row or two above the plots; tasks done at about the same
/// time share a box.
class TaskBoxes {
public:
    TaskBoxes(const RunReport& report, const TimeScale& time);
    double height_mm() const;
    void draw(QPainter& painter, double top_mm) const;

private:
    QString words(const std::vector<int>& places) const;
    double width(const std::vector<int>& places) const;
    void drawBox(QPainter& painter, const Marker& marker, double top_mm) const;

    std::vector<DoneTask> m_tasks;
    std::vector<Marker> m_markers;
};

/// In the frame of one plot: a thin line for every task done and a short red tick for every deduction.
void drawMoments(QPainter& painter, const RunReport& report, const TimeScale& time, const QRectF& frame);

/// The numbers of the deductions below the time axis, and the height they need there.
double deductionNumbersHeight_mm(const RunReport& report);
void drawDeductionNumbers(QPainter& painter, const RunReport& report, const TimeScale& time, double top_mm);

}  // namespace sagara::report
