#pragma once

#include <QColor>
#include <QPainter>

namespace sagara::ui {

/// A rose of true directions. `north_rad`: where true north is, clockwise from up.
void drawCompassRose(QPainter& painter, QPointF middle, double radius_px, double north_rad, const QColor& ink,
                     const QColor& halo);

}  // namespace sagara::ui
