#include "ui/trainee/ShaftGauge.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"

namespace sagara::ui::console {

ShaftGauge::ShaftGauge(const std::vector<QString>& names, double most_rps, QWidget* parent)
    : Gauge(tr("Shafts rpm"), 1.9, parent), m_most_rps(std::max(0.01, most_rps)) {
    for (const QString& name : names) m_shafts.push_back({name});
    setToolTip(tr("Turns of each shaft a minute, astern to the left; the arrow is the order"));
}

void ShaftGauge::setShaft(std::size_t shaft, double speed_rps, double order_rps) {
    if (shaft >= m_shafts.size()) return;
    m_shafts[shaft].speed_rps = speed_rps;
    m_shafts[shaft].order_rps = order_rps;
    update();
}

void ShaftGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    if (m_shafts.empty()) return;
    const double row = box.height() / static_cast<double>(m_shafts.size());
    const double size = std::min(0.36 * row, 20.0 * unit());
    for (std::size_t i = 0; i < m_shafts.size(); ++i) {
        const Shaft& shaft = m_shafts[i];
        const QRectF line(box.left(), box.top() + static_cast<double>(i) * row, box.width(), row);
        const QRectF words(line.left(), line.top(), line.width(), 0.55 * row);
        drawWords(painter, words, Qt::AlignLeft | Qt::AlignVCenter, shaft.name,
                  std::min(0.7 * size, 12.0 * unit()), colours().quietText);
        drawWords(painter, words, Qt::AlignRight | Qt::AlignVCenter,
                  chart::number(shaft.speed_rps / core::kRpm_rps, 0), size, colours().text, true);
        const QRectF bar(line.left(), line.top() + 0.64 * row, line.width(), 0.2 * row);
        const auto at = [&](double rps) {
            return bar.center().x() + 0.5 * bar.width() * std::clamp(rps / m_most_rps, -1.0, 1.0);
        };
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours().section);
        painter.drawRect(bar);
        painter.setBrush(shaft.speed_rps < 0.0 ? colours().caution : colours().accent);
        painter.drawRect(QRectF(std::min(at(0.0), at(shaft.speed_rps)), bar.top(),
                                std::abs(at(shaft.speed_rps) - at(0.0)), bar.height()));
        painter.setPen(QPen(colours().tick, 1.2));
        painter.drawLine(QPointF(at(0.0), bar.top() - 2.0), QPointF(at(0.0), bar.bottom() + 2.0));
        painter.setPen(QPen(colours().surface, 1.0));
        painter.setBrush(colours().setValue);
        painter.drawPolygon(pointerAt({at(shaft.order_rps), bar.bottom() - 1.0}, 0.22 * row, 0.0));
    }
}

}  // namespace sagara::ui::console
