#pragma once

#include <QPainter>
#include <QPen>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <functional>
#include <vector>

#include "ui/report/Axis.h"

namespace sagara::report {

/// One line of a plot. x: seconds since start, ascending; y: in the unit of the plot, not finite where the
/// line breaks.
struct PlotSeries {
    QString name;  ///< in the key; empty when there is only one
    QPen pen;
    std::vector<QPointF> points;
};

/// What one plot over time shows.
struct Plot {
    QString title;   ///< quantity, unit and what is positive
    QString remark;  ///< at the right: the extreme and when
    std::vector<PlotSeries> series;
    Axis axis;
    std::function<QString(double)> tickText;
};

/// The time axis that all plots of a page share.
struct TimeScale {
    double left_mm = 0.0;
    double width_mm = 1.0;
    double end_s = 1.0;

    double x_mm(double time_s) const;
    double right_mm() const { return left_mm + width_mm; }
};

/// Title line, frame, grid, tick texts and lines. The tick texts stand to the left of the scale.
void drawPlot(QPainter& painter, const Plot& plot, const TimeScale& time, double top_mm, double height_mm);
/// The frame in which the lines lie.
QRectF plotFrame(const TimeScale& time, double top_mm, double height_mm);

}  // namespace sagara::report
