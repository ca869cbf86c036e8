#include "ui/trainee/DepthGauge.h"

#include <cmath>

#include "ui/chart/Format.h"

namespace sagara::ui::console {

DepthGauge::DepthGauge(QWidget* parent) : Gauge(tr("Under keel m"), 1.3, parent) {
    setToolTip(
        tr("Water under the transducer at the keel in metres, by echo sounder; alarm at the depth set "
           "there. Cut off, never rounded up"));
}

void DepthGauge::setDepth(std::optional<double> underKeel_m, double alarm_m) {
    m_underKeel_m = underKeel_m;
    m_alarm_m = alarm_m;
    update();
}

void DepthGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    const bool shallow = m_underKeel_m && *m_underKeel_m < m_alarm_m;
    const QRectF value(box.left(), box.top() + 4.0 * unit(), box.width(), 40.0 * unit());
    if (shallow) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours().alarm);
        painter.drawRoundedRect(value, 3.0, 3.0);
    }
    drawWords(painter, value, Qt::AlignCenter,
              m_underKeel_m ? chart::number(std::floor(*m_underKeel_m * 10.0) / 10.0, 1) : tr("no echo"),
              36.0 * unit(), shallow ? colours().onAlarm : colours().text, true);
    drawWords(painter, QRectF(box.left(), box.bottom() - 17.0 * unit(), box.width(), 15.0 * unit()),
              Qt::AlignCenter, tr("alarm %1").arg(chart::number(m_alarm_m, 1)), 13.0 * unit(),
              colours().quietText);
}

}  // namespace sagara::ui::console
