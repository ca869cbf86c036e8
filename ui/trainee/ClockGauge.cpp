#include "ui/trainee/ClockGauge.h"

namespace sagara::ui::console {

ClockGauge::ClockGauge(const QString& zone, QWidget* parent) : Gauge(tr("Time"), 1.5, parent), m_zone(zone) {
    setToolTip(tr("Local time of the area (%1) and UTC, as hours, minutes, seconds").arg(zone));
}

void ClockGauge::setTimes(const QString& local, const QString& utc) {
    if (local == m_local && utc == m_utc) return;
    m_local = local;
    m_utc = utc;
    update();
}

void ClockGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    drawWords(painter, QRectF(box.left(), box.top() + 2.0 * unit(), box.width(), 30.0 * unit()),
              Qt::AlignCenter, m_local, 28.0 * unit(), colours().text, true);
    drawWords(painter, QRectF(box.left(), box.top() + 32.0 * unit(), box.width(), 14.0 * unit()),
              Qt::AlignCenter, m_zone, 11.0 * unit(), colours().quietText);
    drawWords(painter, QRectF(box.left(), box.bottom() - 20.0 * unit(), box.width(), 17.0 * unit()),
              Qt::AlignCenter, m_utc, 16.0 * unit(), colours().text);
}

}  // namespace sagara::ui::console
