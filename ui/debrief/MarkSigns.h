#pragma once

#include <QColor>
#include <QPointF>

#include "ui/debrief/Marks.h"
#include "ui/theme/ThemeColours.h"

class QPainter;

namespace sagara::ui {

/// One sign for a kind of mark, on timeline, plots and chart; told apart by shape as much as by colour.
QColor markColour(MarkKind kind, const ThemeColours& colours);
void drawMarkSign(QPainter& painter, QPointF at, MarkKind kind, double half_px, const ThemeColours& colours);

}  // namespace sagara::ui
