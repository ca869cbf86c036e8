#pragma once

#include <QPainter>
#include <QPointF>
#include <string_view>

#include "core/world/Area.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// A mark of an area with the colour the IALA region ("A" or "B") gives it.
ChartMark chartMarkOf(const core::Mark& mark, std::string_view ialaRegion);

/// The symbol, about `size_mm` high, its position at `at`. Shapes follow the topmarks: can, cone, two cones,
/// sphere, cross.
void drawMark(QPainter& painter, QPointF at, const ChartMark& mark, double size_mm);

}  // namespace sagara::report
