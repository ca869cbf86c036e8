#pragma once

#include <QPainter>
#include <QPointF>

namespace sagara::chart {

/// Ring, stock, shank and flukes about the place of the anchor, with the painter's pen. `half`: half its
/// height.
void strokeAnchor(QPainter& painter, QPointF at, double half);

}  // namespace sagara::chart
