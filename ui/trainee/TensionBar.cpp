#include "ui/trainee/TensionBar.h"

#include <QFontInfo>
#include <algorithm>

#include "ui/chart/Format.h"

namespace sagara::ui::console {

TensionBar::TensionBar(double breaking_N, QWidget* parent)
    : Gauge(tr("Tension"), 4.0, parent), m_breaking_N(breaking_N) {
    setMinimumSize(0, 0);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Tension in kN; the whole bar is the breaking load of %1 kN")
                   .arg(chart::number(breaking_N / 1000.0, 0)));
}

QSize TensionBar::sizeHint() const { return {80, fontMetrics().height() + 8}; }

void TensionBar::setTension(double tension_N) {
    if (tension_N == m_tension_N) return;
    m_tension_N = tension_N;
    update();
}

void TensionBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = QRectF(rect()).adjusted(0.5, 2.5, -0.5, -2.5);
    const double part = m_breaking_N > 0.0 ? std::clamp(m_tension_N / m_breaking_N, 0.0, 1.0) : 0.0;
    painter.fillRect(box, colours().section);
    const QColor colour = part >= 0.8 ? colours().alarm : part >= 0.5 ? colours().caution : colours().pressed;
    const QColor ink = part >= 0.8 ? colours().onAlarm : part >= 0.5 ? colours().onCaution : colours().text;
    painter.fillRect(QRectF(box.left(), box.top(), part * box.width(), box.height()), colour);
    painter.setPen(colours().border);
    painter.drawRect(box);
    const QRectF words = box.adjusted(4.0, 0.0, -4.0, 0.0);
    drawWords(painter, words, part >= 0.5 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter,
              tr("%1 kN").arg(chart::number(m_tension_N / 1000.0, 0)), QFontInfo(font()).pixelSize(), ink);
}

}  // namespace sagara::ui::console
