#include "ui/widgets/ChartCanvas.h"

#include <cmath>
#include <optional>

namespace sagara::ui {

QPen chartPen(const QColor& colour, double width_px, Qt::PenStyle style) {
    return QPen(colour, width_px, style, Qt::FlatCap, Qt::RoundJoin);
}

QPen dashedChartPen(const QColor& colour, double width_px, double dash_px, double gap_px) {
    QPen pen = chartPen(colour, width_px);
    pen.setDashPattern({dash_px / width_px, gap_px / width_px});
    return pen;
}

bool labelNear(ChartCanvas& canvas, QPointF at, double gap_px, double reach_px, const QStringList& lines,
               const Lettering& lettering) {
    const std::optional<QRectF> box =
        canvas.labels.place(at, textSize_px(lines, lettering) + QSizeF(2.0, 0.0), gap_px, reach_px);
    if (!box) return false;
    const double off = box->center().x() - at.x();
    const Qt::Alignment side = std::abs(off) < 0.25 * box->width() ? Qt::AlignHCenter
                               : off > 0.0                         ? Qt::AlignLeft
                                                                   : Qt::AlignRight;
    drawLines(canvas.painter, box->adjusted(1.0, 0.0, -1.0, 0.0), side, lines, lettering);
    return true;
}

QStringList inTwoLines(const QString& words, const Lettering& lettering, double widest_px) {
    if (textWidth_px(words, lettering) <= widest_px) return {words};
    qsizetype best = -1;
    for (qsizetype i = words.indexOf(u' '); i >= 0; i = words.indexOf(u' ', i + 1)) {
        if (best < 0 || std::abs(2 * i - words.size()) < std::abs(2 * best - words.size())) best = i;
    }
    if (best < 0) return {words};
    return {words.left(best), words.mid(best + 1)};
}

}  // namespace sagara::ui
