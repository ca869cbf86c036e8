#pragma once

#include <QPainter>
#include <QRectF>
#include <QSizeF>

#include "ui/report/ChartView.h"

namespace sagara::report {

/// Size of the box with the scale bar, and with the north arrow at its right when it has one.
QSizeF scaleBoxSize_mm(const ChartView& view, bool northArrow);
/// A bar in cables and an arrow to true north at the middle of the chart. `north_rad`: its direction on the
/// page.
void drawScaleBox(QPainter& painter, const QRectF& box, const ChartView& view, bool northArrow,
                  double north_rad);

/// "1:15 000"
QString scaleText(const ChartView& view);

}  // namespace sagara::report
