#include "ui/trainee/HelmWheel.h"

#include <QKeyEvent>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui::console {
namespace {

constexpr double kHalfSweep_rad = 62.0 * core::kDegree_rad;  ///< of the arc, for the full rudder

}  // namespace

HelmWheel::HelmWheel(double limit_rad, QWidget* parent)
    : Lever(tr("Helm"), 1.6, parent), m_limit_rad(limit_rad) {
    setObjectName(QStringLiteral("helm"));
    setToolTip(tr("Rudder order, %1° each way: drag, mouse wheel a degree, double click midships; "
                  "keys ← → a degree, Shift ← → five, M midships")
                   .arg(limit_rad / core::kDegree_rad, 0, 'f', 0));
}

void HelmWheel::setOrder(double order_rad) {
    if (held() || order_rad == m_order_rad) return;
    m_order_rad = order_rad;
    update();
}

void HelmWheel::setRudder(double angle_rad) {
    m_rudder_rad = angle_rad;
    update();
}

void HelmWheel::turnTo(double order_rad) {
    const double whole_rad = std::round(order_rad / core::kDegree_rad) * core::kDegree_rad;
    m_order_rad = std::clamp(whole_rad, -m_limit_rad, m_limit_rad);
    update();
    Q_EMIT ordered(m_order_rad);
}

HelmWheel::Arc HelmWheel::arc() const {
    const double top = 26.0 * unit(), bottom = height() - 30.0 * unit();
    const double side = 0.5 * width() - 18.0 * unit();
    // Whichever is smaller: as high as there is room, or as wide.
    const double byWidth = side / std::sin(kHalfSweep_rad);
    const double byHeight = (bottom - top) / (1.0 - std::cos(kHalfSweep_rad));
    const double radius = std::min(byWidth, byHeight);
    const double rise = radius * (1.0 - std::cos(kHalfSweep_rad));
    return {{0.5 * width(), top + 0.5 * (bottom - top - rise) + radius}, radius};
}

QPointF HelmWheel::at(double rudder_rad, double radius) const {
    const double a = kHalfSweep_rad * std::clamp(rudder_rad / m_limit_rad, -1.0, 1.0);
    return arc().centre + radius * QPointF(std::sin(a), -std::cos(a));
}

double HelmWheel::rudderAt(QPointF p) const {
    const QPointF d = p - arc().centre;
    return m_limit_rad * std::atan2(d.x(), std::max(1.0, -d.y())) / kHalfSweep_rad;
}

void HelmWheel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawFrame(painter);
    const Arc a = arc();
    const double wide = 9.0 * unit(), half_deg = kHalfSweep_rad / core::kDegree_rad;
    const QRectF circle(a.centre.x() - a.radius, a.centre.y() - a.radius, 2.0 * a.radius, 2.0 * a.radius);
    const auto sweep = [&](double from_deg, double to_deg, const QColor& colour) {
        painter.setPen(QPen(colour, wide, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(circle, static_cast<int>(16.0 * (90.0 - to_deg)),
                        static_cast<int>(16.0 * (to_deg - from_deg)));
    };
    painter.setBrush(Qt::NoBrush);
    sweep(-half_deg, half_deg, colours().section);
    const double turned_deg = half_deg * std::clamp(m_rudder_rad / m_limit_rad, -1.0, 1.0);
    if (turned_deg < 0.0) sweep(turned_deg, 0.0, colours().port);
    if (turned_deg > 0.0) sweep(0.0, turned_deg, colours().starboard);
    const double limit_deg = m_limit_rad / core::kDegree_rad;
    const double words = a.radius - 0.5 * wide - 11.0 * unit();
    int worded = 10;  // degrees; fewer where they would run into one another
    while (worded < 30 && worded / limit_deg * kHalfSweep_rad * words < 13.0 * unit()) worded += 10;
    for (int tick = -90; tick <= 90; tick += 5) {
        if (std::abs(tick) > limit_deg + 0.1) continue;
        const bool ten = tick % 10 == 0;
        const double rudder_rad = tick * core::kDegree_rad;
        painter.setPen(QPen(ten ? colours().tick : colours().quietTick, ten ? 1.6 : 1.0));
        painter.drawLine(at(rudder_rad, a.radius - 0.5 * wide),
                         at(rudder_rad, a.radius - 0.5 * wide - (ten ? 5.0 : 3.0) * unit()));
        if (tick % worded != 0) continue;
        const QPointF word = at(rudder_rad, words);
        drawWords(painter,
                  QRectF(word.x() - 12.0 * unit(), word.y() - 6.0 * unit(), 24.0 * unit(), 12.0 * unit()),
                  Qt::AlignCenter, QString::number(std::abs(tick)), 8.5 * unit(), colours().quietText);
    }
    painter.setPen(QPen(hasFocus() ? colours().focus : colours().surface, 2.0));
    painter.setBrush(colours().setValue);
    painter.drawEllipse(at(m_order_rad, a.radius), 8.0 * unit(), 8.0 * unit());
    drawWords(painter, QRectF(0.0, height() - 29.0 * unit(), width(), 16.0 * unit()), Qt::AlignCenter,
              tr("%1°").arg(sided(m_order_rad / core::kDegree_rad, 0)), 15.0 * unit(), colours().setValue,
              true);
    drawWords(painter, QRectF(0.0, height() - 14.0 * unit(), width(), 11.0 * unit()), Qt::AlignCenter,
              tr("rudder %1°").arg(sided(m_rudder_rad / core::kDegree_rad, 0)), 9.5 * unit(), colours().text);
}

void HelmWheel::take(QPointF p) { turnTo(rudderAt(p)); }

void HelmWheel::stepUp(int steps) { turnTo(m_order_rad - steps * core::kDegree_rad); }

bool HelmWheel::rest() {
    turnTo(0.0);
    return true;
}

void HelmWheel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_M) return turnTo(0.0);
    Lever::keyPressEvent(event);
}

}  // namespace sagara::ui::console
