#pragma once

#include <QPointF>
#include <QString>

#include "ui/report/TimePlot.h"

/// The extremes of a plot in words.
namespace sagara::report {

/// The point with the lowest or highest finite value; nothing when there is none.
const QPointF* lowest(const PlotSeries& series);
const QPointF* highest(const PlotSeries& series);

/// "most 9.8 at 12:20"; nothing for no point.
QString remark(const QString& word, const QPointF* p, int decimals);
/// "most 26 to port at 21:49" of the value farthest from zero; nothing when all round to zero.
QString sidedRemark(const PlotSeries& series, int decimals);

}  // namespace sagara::report
