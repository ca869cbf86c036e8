#pragma once

#include <QList>
#include <QPolygonF>
#include <QRectF>
#include <span>

#include "ui/widgets/ChartTransform.h"
#include "ui/widgets/PreparedChart.h"

/// Lines of frame N brought to the screen: cut off outside of it and with no more points than pixels.
namespace sagara::ui {

/// A closed ring cut to the clip; edges along the clip are added. Empty when nothing is left.
QPolygonF screenRing(const ChartTransform& view, std::span<const core::NorthEast> ring, const QRectF& clip);

/// The pieces of an open line that come near the clip.
QList<QPolygonF> screenPieces(const ChartTransform& view, std::span<const core::NorthEast> line,
                              const QRectF& clip);

/// Whether two boxes have anything in common.
bool meets(const chart::Extent& a, const chart::Extent& b);

}  // namespace sagara::ui
