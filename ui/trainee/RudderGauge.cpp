#include "ui/trainee/RudderGauge.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui::console {

RudderGauge::RudderGauge(double limit_rad, QWidget* parent)
    : Gauge(tr("Rudder °"), 1.9, parent), m_limit_rad(limit_rad) {
    setToolTip(tr("Angle of the rudder in degrees, port or starboard; the arrow is the order"));
}

void RudderGauge::setRudder(double angle_rad, double order_rad) {
    m_angle_rad = angle_rad;
    m_order_rad = order_rad;
    update();
}

void RudderGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    const double angle_deg = m_angle_rad / core::kDegree_rad, order_deg = m_order_rad / core::kDegree_rad;
    const double limit_deg = m_limit_rad / core::kDegree_rad;
    drawWords(painter, QRectF(box.left(), box.top() - 2.0 * unit(), box.width(), 27.0 * unit()),
              Qt::AlignCenter, sided(angle_deg, 1), 25.0 * unit(), colours().text, true);
    const QRectF bar(box.left() + 4.0, box.top() + 34.0 * unit(), box.width() - 8.0, 9.0 * unit());
    const auto at = [&](double deg) {
        return bar.center().x() + 0.5 * bar.width() * std::clamp(deg / limit_deg, -1.0, 1.0);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().section);
    painter.drawRect(bar);
    painter.setBrush(angle_deg < 0.0 ? colours().port : colours().starboard);
    painter.drawRect(
        QRectF(std::min(at(0.0), at(angle_deg)), bar.top(), std::abs(at(angle_deg) - at(0.0)), bar.height()));
    const int step = 10;
    const int worded = at(step) - at(0.0) < 17.0 * unit() ? 2 * step : step;  // apart from one another
    for (int tick = -90; tick <= 90; tick += step / 2) {
        if (std::abs(tick) > limit_deg + 0.1) continue;
        const bool ten = tick % step == 0;
        painter.setPen(QPen(ten ? colours().tick : colours().quietTick, ten ? 1.4 : 1.0));
        painter.drawLine(QPointF(at(tick), bar.bottom()),
                         QPointF(at(tick), bar.bottom() + (ten ? 6.0 : 3.5) * unit()));
        if (tick % worded == 0 && std::abs(tick) + 4 <= limit_deg)
            drawWords(
                painter,
                QRectF(at(tick) - 14.0 * unit(), bar.bottom() + 6.0 * unit(), 28.0 * unit(), 14.0 * unit()),
                Qt::AlignHCenter | Qt::AlignTop, QString::number(std::abs(tick)), 11.0 * unit(),
                colours().quietText);
    }
    painter.setPen(QPen(colours().surface, 1.0));
    painter.setBrush(colours().setValue);
    painter.drawPolygon(pointerAt({at(order_deg), bar.top() + 2.0}, 10.0 * unit(), 180.0));
    drawWords(painter, QRectF(box.left(), box.bottom() - 13.0 * unit(), box.width(), 13.0 * unit()),
              Qt::AlignCenter, tr("ordered %1").arg(sided(order_deg, 0)), 12.0 * unit(), colours().setValue);
}

}  // namespace sagara::ui::console
