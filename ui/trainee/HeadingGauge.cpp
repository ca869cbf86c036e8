#include "ui/trainee/HeadingGauge.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::ui::console {
namespace {

constexpr double kHalfTape_deg = 40.0;
constexpr double kMostTurn_degpmin = 90.0;

double degrees(double rad) { return rad / core::kDegree_rad; }

}  // namespace

HeadingGauge::HeadingGauge(QWidget* parent) : Gauge(tr("Heading °T"), 2.5, parent) {
    setToolTip(
        tr("True heading in degrees; open arrow: course over the ground; filled arrow: heading the "
           "autopilot steers; below: rate of turn in degrees a minute"));
}

void HeadingGauge::setHeading(double heading_rad, double turn_radps) {
    m_heading_rad = heading_rad;
    m_turn_radps = turn_radps;
    update();
}

void HeadingGauge::drawTape(QPainter& painter, const QRectF& box) const {
    painter.save();
    painter.setClipRect(box);
    const double heading_deg = degrees(core::wrapTwoPi(m_heading_rad));
    const double perDegree = box.width() / (2.0 * kHalfTape_deg);
    const auto at = [&](double off_deg) { return box.center().x() + perDegree * off_deg; };
    const auto first = static_cast<int>(std::floor((heading_deg - kHalfTape_deg) / 5.0)) * 5;
    for (int tick = first; tick <= heading_deg + kHalfTape_deg; tick += 5) {
        const double x = at(tick - heading_deg);
        const bool ten = tick % 10 == 0;
        painter.setPen(QPen(ten ? colours().tick : colours().quietTick, ten ? 1.6 : 1.0));
        painter.drawLine(QPointF(x, box.top()), QPointF(x, box.top() + (ten ? 0.32 : 0.2) * box.height()));
        if (!ten) continue;
        const QRectF words(x - 20.0, box.top() + 0.36 * box.height(), 40.0, 0.6 * box.height());
        drawWords(painter, words, Qt::AlignHCenter | Qt::AlignTop,
                  QStringLiteral("%1").arg((tick % 360 + 360) % 360, 3, 10, QLatin1Char('0')), 12.0 * unit(),
                  colours().text);
    }
    const auto mark = [&](double direction_rad, bool filled, const QColor& colour) {
        const double off_deg =
            std::clamp(degrees(core::wrapPi(direction_rad - m_heading_rad)), -kHalfTape_deg, kHalfTape_deg);
        painter.setPen(QPen(colour, 1.8));
        painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
        painter.drawPolygon(pointerAt({at(off_deg), box.top() + 1.0}, 11.0 * unit(), 0.0));
    };
    if (m_course_rad) mark(*m_course_rad, false, colours().accent);
    if (m_ordered_rad) mark(*m_ordered_rad, true, colours().setValue);
    painter.restore();
    painter.setPen(QPen(colours().text, 2.0));
    painter.drawLine(QPointF(box.center().x(), box.top() - 2.0),
                     QPointF(box.center().x(), box.top() + 0.36 * box.height()));
}

void HeadingGauge::drawTurn(QPainter& painter, const QRectF& box) const {
    const double turn_degpmin = 60.0 * degrees(m_turn_radps);
    const QRectF words(box.right() - 66.0 * unit(), box.top(), 66.0 * unit(), box.height());
    drawWords(painter, words, Qt::AlignRight | Qt::AlignVCenter, tr("%1°/min").arg(sided(turn_degpmin, 0)),
              13.0 * unit(), colours().text, true);
    const QRectF bar(box.left(), box.center().y() - 3.5 * unit(), box.width() - 70.0 * unit(), 7.0 * unit());
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().section);
    painter.drawRect(bar);
    const double part = std::clamp(turn_degpmin / kMostTurn_degpmin, -1.0, 1.0);
    const double middle = bar.center().x(), length = 0.5 * bar.width() * part;
    painter.setBrush(part < 0.0 ? colours().port : colours().starboard);
    painter.drawRect(QRectF(std::min(middle, middle + length), bar.top(), std::abs(length), bar.height()));
    painter.setPen(QPen(colours().tick, 1.2));
    for (int tick = -90; tick <= 90; tick += 30) {
        const double x = middle + 0.5 * bar.width() * tick / kMostTurn_degpmin;
        painter.drawLine(QPointF(x, bar.top() - (tick == 0 ? 3.0 : 0.0)), QPointF(x, bar.bottom()));
    }
}

void HeadingGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    const QString digits = QStringLiteral("%1").arg(
        std::fmod(degrees(core::wrapTwoPi(m_heading_rad)), 359.95), 5, 'f', 1, QLatin1Char('0'));
    drawWords(painter, QRectF(box.left(), box.top() - 13.0 * unit(), box.width(), 27.0 * unit()),
              Qt::AlignCenter, digits, 27.0 * unit(), colours().text, true);
    drawTape(painter, QRectF(box.left(), box.top() + 18.0 * unit(), box.width(), 32.0 * unit()));
    drawTurn(painter, QRectF(box.left(), box.bottom() - 17.0 * unit(), box.width(), 15.0 * unit()));
}

}  // namespace sagara::ui::console
