#include "ui/report/ChartSigns.h"

#include <algorithm>

#include "ui/chart/AnchorSign.h"
#include "ui/report/Style.h"

namespace sagara::report {
QPen trackPen() { return linePen(colour::kInk, 0.3); }
QPen routePen() { return dashedPen(colour::kRoute, 0.3, 2.2, 1.1); }
QPen corridorEdgePen() { return linePen(colour::kRoute, 0.12); }
QPen tickPen() { return linePen(colour::kInk, 0.35); }

QPen otherTrackPen(bool hostile) {
    return hostile ? dashedPen(colour::kHostile, 0.25, 1.4, 0.6) : linePen(colour::kOther, 0.2);
}

void drawWaypointSign(QPainter& painter, QPointF at, double radius_mm) {
    painter.setPen(linePen(colour::kRoute, 0.3));
    painter.setBrush(colour::kPaper);
    painter.drawEllipse(at, radius_mm, radius_mm);
}

void drawAnchorSign(QPainter& painter, QPointF at, double half_mm) {
    painter.setPen(linePen(colour::kPaper, 0.9));
    chart::strokeAnchor(painter, at, half_mm);
    painter.setPen(linePen(colour::kInk, 0.35));
    chart::strokeAnchor(painter, at, half_mm);
}

void drawDeductionCross(QPainter& painter, QPointF at) {
    constexpr double kHalf_mm = 0.7;
    painter.setPen(linePen(colour::kFailed, 0.5));
    painter.drawLine(at + QPointF(-kHalf_mm, -kHalf_mm), at + QPointF(kHalf_mm, kHalf_mm));
    painter.drawLine(at + QPointF(-kHalf_mm, kHalf_mm), at + QPointF(kHalf_mm, -kHalf_mm));
}

void drawDeductionCapsule(QPainter& painter, const QRectF& box) {
    const double round_mm = std::min(0.5 * box.height(), 1.9);
    painter.setPen(linePen(colour::kFailed, 0.35));
    painter.setBrush(colour::kPaper);
    painter.drawRoundedRect(box, round_mm, round_mm);
}

}  // namespace sagara::report
