#pragma once

#include <QPainter>
#include <QPen>
#include <QPointF>

/// Signs and lines that the chart and its legend both draw.
namespace sagara::report {

QPen trackPen();
QPen routePen();
QPen corridorEdgePen();
QPen tickPen();
QPen otherTrackPen(bool hostile);

/// A ring with paper inside.
void drawWaypointSign(QPainter& painter, QPointF at, double radius_mm);
/// Ring, stock, shank and flukes about the place of the anchor.
void drawAnchorSign(QPainter& painter, QPointF at, double half_mm);
/// The place of a deduction.
void drawDeductionCross(QPainter& painter, QPointF at);
/// The capsule that holds its number.
void drawDeductionCapsule(QPainter& painter, const QRectF& box);

}  // namespace sagara::report
