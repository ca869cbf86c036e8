#include <algorithm>
#include <cmath>

#include "ui/report/Chart.h"

namespace sagara::report {
namespace {

constexpr double kWidest_mm = 34.0;
constexpr double kNextTo_mm = 2.2;  ///< nearer than this needs no leading line

QPointF nearestIn(const QRectF& box, QPointF p) {
    return {std::clamp(p.x(), box.left(), box.right()), std::clamp(p.y(), box.top(), box.bottom())};
}

}  // namespace

void labelNear(Chart& chart, QPointF point, double gap_mm, double reach_mm, const QString& text,
               const TextStyle& style) {
    const TextBlock block(text, style, kWidest_mm, 2);
    const QSizeF size(block.widest_mm() + 0.6, block.height_mm());
    const std::optional<QRectF> box = chart.labels.place(point, size, gap_mm, reach_mm);
    if (!box) return;
    const QPointF end = nearestIn(*box, point);
    if (std::hypot(end.x() - point.x(), end.y() - point.y()) > kNextTo_mm) {
        chart.painter.setPen(linePen(style.colour, 0.12));
        chart.painter.drawLine(point, end);
    }
    if (box->center().x() < point.x()) {
        block.drawWithHalo(chart.painter, {box->right() - 0.3 - kWidest_mm, box->top()}, Qt::AlignRight);
    } else {
        block.drawWithHalo(chart.painter, {box->left() + 0.3, box->top()});
    }
}

}  // namespace sagara::report
