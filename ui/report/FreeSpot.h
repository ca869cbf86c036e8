#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

#include "ui/report/ChartView.h"
#include "ui/report/ReportData.h"

/// Where boxes lie on a chart: the inset, the scale bar.
namespace sagara::report {

/// What must not be hidden: track, route, corridor, deductions and anchors, as points close together on the
/// page.
std::vector<QPointF> pointsToKeepFree(const RunReport& report, const ChartView& view);

/// Corners and edges of a frame where a box of a size may lie.
std::vector<QRectF> boxSpots(const QRectF& frame, QSizeF size);
/// Points inside a box or close to it.
std::size_t hiddenPoints(const QRectF& box, const std::vector<QPointF>& points);

/// The spot where a box hides the fewest points and no blocked rectangle.
QRectF freeSpot(const QRectF& frame, QSizeF size, const std::vector<QPointF>& points,
                const std::vector<QRectF>& blocked);

}  // namespace sagara::report
