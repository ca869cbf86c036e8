#include "ui/report/ChartFurniture.h"

#include "core/base/Units.h"
#include "ui/chart/ScaleBar.h"
#include "ui/report/Format.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kLongestBar_mm = 42.0;
constexpr double kArrow_mm = 10.0;  ///< width of its part of the box
const TextStyle kFigureStyle{6.5};
const TextStyle kNorthStyle{8.0, colour::kInk, true};

/// A bar of four equal parts.
struct Bar {
    double part_cables = 1.0;
    double part_mm = 1.0;
};
constexpr int kParts = 4;

Bar barFor(const ChartView& view) {
    const double part = chart::scaleBarPart_cables(view.toMetres(kLongestBar_mm) / kParts);
    return {part, view.toMm(part * core::kCable_m)};
}

void drawBar(QPainter& painter, const Bar& bar, QPointF at) {
    constexpr double kHigh_mm = 1.4;
    painter.setPen(linePen(colour::kInk, 0.15));
    for (int i = 0; i < kParts; ++i) {
        painter.setBrush(i % 2 == 0 ? colour::kInk : colour::kPaper);
        painter.drawRect(QRectF(at.x() + i * bar.part_mm, at.y(), bar.part_mm, kHigh_mm));
    }
    for (const int i : {0, 2, 4}) {
        const QString figure = shortNumber(i * bar.part_cables, 2);
        drawText(painter, {at.x() + i * bar.part_mm, at.y() - 0.9}, Qt::AlignHCenter, figure, kFigureStyle);
    }
    const QString metres = tr("cables (1 cable = 185.2 m)");
    drawText(painter, {at.x(), at.y() + kHigh_mm + 3.0}, Qt::AlignLeft, metres, kFigureStyle);
}

void drawArrow(QPainter& painter, QPointF middle, double north_rad) {
    painter.save();
    painter.translate(middle);
    painter.rotate(north_rad / core::kDegree_rad);
    painter.setPen(linePen(colour::kInk, 0.2));
    painter.setBrush(colour::kInk);
    painter.drawPolygon(QPolygonF{QPointF(0.0, -4.0), QPointF(-1.7, 4.0), QPointF(0.0, 2.6)});
    painter.setBrush(colour::kPaper);
    painter.drawPolygon(QPolygonF{QPointF(0.0, -4.0), QPointF(1.7, 4.0), QPointF(0.0, 2.6)});
    drawText(painter, {0.0, -4.8}, Qt::AlignHCenter, QStringLiteral("N"), kNorthStyle);
    painter.restore();
}

}  // namespace

QSizeF scaleBoxSize_mm(const ChartView& view, bool northArrow) {
    const Bar bar = barFor(view);
    const double wide_mm = std::max(kParts * bar.part_mm, 30.0) + 6.0;
    return {wide_mm + (northArrow ? kArrow_mm : 0.0), northArrow ? 15.0 : 10.0};
}

void drawScaleBox(QPainter& painter, const QRectF& box, const ChartView& view, bool northArrow,
                  double north_rad) {
    painter.fillRect(box, colour::kPaper);
    const double arrow_mm = northArrow ? kArrow_mm : 0.0;
    drawBar(painter, barFor(view), {box.left() + 3.0, box.center().y() - 0.6});
    if (northArrow) drawArrow(painter, {box.right() - 0.5 * arrow_mm, box.center().y() + 1.8}, north_rad);
}

QString scaleText(const ChartView& view) { return chart::naturalScale(view.denominator()); }

}  // namespace sagara::report
