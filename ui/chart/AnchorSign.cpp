#include "ui/chart/AnchorSign.h"

#include <QPainterPath>

namespace sagara::chart {

void strokeAnchor(QPainter& painter, QPointF at, double half) {
    const auto p = [&](double x, double y) { return at + half * QPointF(x, y); };
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(p(0.0, -0.85), 0.2 * half, 0.2 * half);
    painter.drawLine(p(0.0, -0.65), p(0.0, 1.0));
    painter.drawLine(p(-0.5, -0.35), p(0.5, -0.35));
    QPainterPath flukes(p(-0.85, 0.25));
    flukes.quadTo(p(-0.6, 0.95), p(0.0, 1.0));
    flukes.quadTo(p(0.6, 0.95), p(0.85, 0.25));
    painter.drawPath(flukes);
}

}  // namespace sagara::chart
