#pragma once

#include <QPainter>
#include <QRectF>

#include "ui/report/PilotCard.h"

namespace sagara::report {

/// The turning circles of the wheelhouse poster: both tracks to scale on a grid of ship lengths, with the
/// ship's outline at the start, full minutes and the IMO limits.
void drawTurningCircles(QPainter& painter, const QRectF& area, const PilotCardData::Condition& condition,
                        double length_m);

}  // namespace sagara::report
