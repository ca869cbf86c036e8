#include "ui/trainee/WindGauge.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"

namespace sagara::ui::console {

WindGauge::WindGauge(QWidget* parent) : Gauge(tr("Wind kn"), 2.0, parent) {
    setToolTip(
        tr("Filled arrow: relative wind from the bow. Open arrow: true wind, from where. Speeds in knots"));
}

void WindGauge::setRelative(double from_rad, double speed_mps) {
    m_relativeFrom_rad = core::wrapPi(from_rad);
    m_relative_mps = speed_mps;
    update();
}

void WindGauge::setTrue(double from_rad, double speed_mps, double heading_rad) {
    m_trueFrom_rad = from_rad;
    m_true_mps = speed_mps;
    m_heading_rad = heading_rad;
    update();
}

void WindGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    const double r = 0.5 * std::min(box.height(), 0.42 * box.width()) - 2.0;
    const QPointF c(box.left() + r + 4.0, box.center().y());
    painter.setPen(QPen(colours().quietTick, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(c, r, r);
    for (int tick = 0; tick < 360; tick += 30) {
        const double a = tick * core::kDegree_rad;
        const QPointF out(std::sin(a), -std::cos(a));
        painter.drawLine(c + (tick % 90 == 0 ? 0.8 : 0.88) * r * out, c + r * out);
    }
    QPolygonF hull{QPointF(0.0, -0.5), QPointF(0.16, -0.2), QPointF(0.16, 0.45), QPointF(-0.16, 0.45),
                   QPointF(-0.16, -0.2)};
    for (QPointF& p : hull) p = c + r * p;
    painter.setPen(QPen(colours().quietText, 1.2));
    painter.drawPolygon(hull);
    const auto arrow = [&](double fromBow_rad, const QColor& colour, bool filled) {
        const QPointF out(std::sin(fromBow_rad), -std::cos(fromBow_rad));
        painter.setPen(QPen(colour, 1.8));
        painter.setBrush(filled ? QBrush(colour) : QBrush(colours().surface));
        painter.drawPolygon(pointerAt(c + 0.56 * r * out, 0.42 * r, fromBow_rad / core::kDegree_rad + 180.0));
    };
    if (m_true_mps > 0.05) arrow(m_trueFrom_rad - m_heading_rad, colours().text, false);
    if (m_relative_mps > 0.05) arrow(m_relativeFrom_rad, colours().accent, true);

    const double left = c.x() + r + 8.0, wide = box.right() - left, row = 0.5 * box.height();
    const auto words = [&](double top, const QString& name, const QString& from, double speed_mps,
                           const QColor& colour) {
        drawWords(painter, QRectF(left, top, wide, 0.36 * row), Qt::AlignLeft | Qt::AlignVCenter, name,
                  11.5 * unit(), colours().quietText);
        drawWords(painter, QRectF(left, top + 0.36 * row, wide, 0.6 * row), Qt::AlignLeft | Qt::AlignVCenter,
                  QStringLiteral("%1  %2").arg(chart::number(speed_mps / core::kKnot_mps, 0), from),
                  18.0 * unit(), colour, true);
    };
    words(box.top(), tr("relative"), tr("%1°").arg(sided(m_relativeFrom_rad / core::kDegree_rad, 0)),
          m_relative_mps, colours().accent);
    words(box.top() + row, tr("true, from"),
          tr("%1°T").arg(chart::bearing(core::wrapTwoPi(m_trueFrom_rad) / core::kDegree_rad)), m_true_mps,
          colours().text);
}

}  // namespace sagara::ui::console
