#include "ui/trainee/ThrusterLever.h"

#include <QFontInfo>
#include <algorithm>
#include <cmath>

namespace sagara::ui::console {
namespace {

constexpr double kStep = 0.1;

}  // namespace

ThrusterLever::ThrusterLever(const QString& name, const QString& keys, QWidget* parent)
    : Lever(name, 1.5, parent) {
    setToolTip(tr("%1, 0 to 100 % each way: click or drag, to the right pushes her end to starboard; mouse "
                  "wheel a tenth, double click stop. The bar is what it pushes; at some 3 knots "
                  "half of that is lost")
                   .arg(name) +
               (keys.isEmpty() ? QString() : tr("; keys %1").arg(keys)));
}

void ThrusterLever::setOrder(double order) {
    if (held() || order == m_order) return;
    m_order = order;
    update();
}

void ThrusterLever::setThrust(double share) {
    if (share == m_share) return;
    m_share = share;
    update();
}

void ThrusterLever::moveTo(double order) {
    m_order = std::clamp(std::round(order / kStep) * kStep, -1.0, 1.0);
    update();
    Q_EMIT ordered(m_order);
}

QRectF ThrusterLever::track() const {
    const double letters = QFontInfo(font()).pixelSize();
    const double high = std::clamp(0.16 * height(), 8.0, 1.6 * letters);
    return {0.09 * width(), 0.5 * height() - 0.5 * high + 0.2 * letters, 0.82 * width(), high};
}

double ThrusterLever::xOf(double share) const {
    const QRectF t = track();
    return t.center().x() + 0.5 * share * t.width();
}

void ThrusterLever::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawFrame(painter);
    const QRectF t = track();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().section);
    painter.drawRoundedRect(t, 3.0, 3.0);
    painter.setBrush(m_share < 0.0 ? colours().port : colours().starboard);
    const double to = xOf(m_share), middle = xOf(0.0);
    painter.drawRect(
        QRectF(std::min(to, middle), t.top() + 0.25 * t.height(), std::abs(to - middle), 0.5 * t.height()));
    for (int fifth = -5; fifth <= 5; ++fifth) {
        painter.setPen(QPen(fifth == 0 ? colours().tick : colours().quietTick, fifth == 0 ? 1.6 : 1.0));
        const double x = xOf(0.2 * fifth);
        painter.drawLine(QPointF(x, t.top() - 0.35 * t.height()), QPointF(x, t.top() - 2.0));
    }
    prepareKnob(painter);
    const double half = 0.3 * t.height();
    painter.drawRoundedRect(
        QRectF(xOf(m_order) - half, t.top() - 0.2 * t.height(), 2.0 * half, 1.4 * t.height()), 3.0, 3.0);
    const double letters = QFontInfo(font()).pixelSize();
    const QRectF below(6.0, height() - 1.5 * letters - 3.0, width() - 12.0, 1.5 * letters);
    drawWords(painter, below, Qt::AlignCenter, tr("%1 %").arg(sided(100.0 * m_order, 0)), 1.2 * letters,
              colours().setValue, true);
    drawWords(painter, below, Qt::AlignLeft | Qt::AlignVCenter, tr("port"), 0.9 * letters,
              colours().quietText);
    drawWords(painter, below, Qt::AlignRight | Qt::AlignVCenter, tr("stbd"), 0.9 * letters,
              colours().quietText);
}

void ThrusterLever::take(QPointF p) {
    const QRectF t = track();
    moveTo((p.x() - t.center().x()) / (0.5 * t.width()));
}

/// As the wheel of the ship: up is to port.
void ThrusterLever::stepUp(int steps) { moveTo(m_order - steps * kStep); }

bool ThrusterLever::rest() {
    moveTo(0.0);
    return true;
}

}  // namespace sagara::ui::console
