#pragma once

#include <QPainter>
#include <QRectF>

#include "ui/report/ReportData.h"

namespace sagara::report {

/// What the signs of the chart page mean; only those that the run has. `interval_s`: between two outlines of
/// the ship.
void drawChartLegend(QPainter& painter, const RunReport& report, const QRectF& area, double interval_s,
                     bool hasInset);

}  // namespace sagara::report
