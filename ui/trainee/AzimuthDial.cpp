#include "ui/trainee/AzimuthDial.h"

#include <QFontInfo>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::ui::console {
namespace {

constexpr double kStep_rad = 5.0 * core::kDegree_rad;

double rounded_rad(double angle_rad) { return core::wrapPi(std::round(angle_rad / kStep_rad) * kStep_rad); }

QPointF towards(double angle_rad) { return {std::sin(angle_rad), -std::cos(angle_rad)}; }

/// "045°", from ahead clockwise.
QString degrees(double angle_rad) {
    const long whole = std::lround(core::wrapTwoPi(angle_rad) / core::kDegree_rad) % 360;
    return QStringLiteral("%1°").arg(whole, 3, 10, QLatin1Char('0'));
}

}  // namespace

AzimuthDial::AzimuthDial(const QString& shaft, QWidget* parent) : Lever(tr("Drive"), 0.65, parent) {
    setAccessibleName(tr("Azimuth drive, %1").arg(shaft));
    setToolTip(
        tr("Where the %1 drive pushes the ship, clockwise from ahead: click or drag round; mouse wheel "
           "or ↑ ↓ 5° (↑ clockwise); keys O and P all of them; double click ahead. The arrow is the "
           "drive as it is: the wheel turns it on top of this order")
            .arg(shaft));
}

void AzimuthDial::setOrder(double angle_rad) {
    if (held() || angle_rad == m_order_rad) return;
    m_order_rad = angle_rad;
    update();
}

void AzimuthDial::setAngle(double angle_rad) {
    if (angle_rad == m_angle_rad) return;
    m_angle_rad = angle_rad;
    update();
}

void AzimuthDial::turnTo(double angle_rad) {
    m_order_rad = rounded_rad(angle_rad);
    update();
    Q_EMIT ordered(m_order_rad);
}

AzimuthDial::Circle AzimuthDial::circle() const {
    const double top = 13.0 * unit(), bottom = height() - 25.0 * unit();
    const double knob = 4.5 * unit();
    const double radius = std::min(0.5 * (bottom - top), 0.5 * width() - 3.0) - knob;
    return {{0.5 * width(), 0.5 * (top + bottom)}, radius};
}

void AzimuthDial::drawScale(QPainter& painter) const {
    const Circle c = circle();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours().section, 6.0 * unit()));
    painter.drawEllipse(c.centre, c.radius, c.radius);
    const double inner = c.radius - 4.0 * unit(), letters = QFontInfo(font()).pixelSize();
    for (int mark = 0; mark < 360; mark += 30) {
        const bool main = mark % 90 == 0;
        const QPointF out = towards(mark * core::kDegree_rad);
        painter.setPen(QPen(main ? colours().tick : colours().quietTick, main ? 1.6 : 1.0));
        painter.drawLine(c.centre + inner * out, c.centre + (inner - (main ? 4.0 : 2.5) * unit()) * out);
        if (!main) continue;
        const QPointF at = c.centre + (inner - 9.5 * unit()) * out;
        const QRectF word(at.x() - 9.0 * unit(), at.y() - 5.0 * unit(), 18.0 * unit(), 10.0 * unit());
        drawWords(painter, word, Qt::AlignCenter, QString::number(mark), 0.75 * letters, colours().quietText);
    }
}

void AzimuthDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawFrame(painter);
    drawScale(painter);
    const Circle c = circle();
    const double letters = QFontInfo(font()).pixelSize();
    const QPointF out = towards(m_angle_rad), tip = c.centre + (c.radius - 4.0 * unit()) * out;
    painter.setPen(QPen(colours().accent, 2.2 * unit(), Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(c.centre - 0.35 * c.radius * out, tip - 5.0 * unit() * out);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().accent);
    painter.drawPolygon(pointerAt(tip, 9.0 * unit(), m_angle_rad / core::kDegree_rad));
    prepareKnob(painter);
    painter.drawEllipse(c.centre + c.radius * towards(m_order_rad), 4.5 * unit(), 4.5 * unit());
    const double foot = height() - 23.5 * unit(), row = 0.5 * (height() - foot - 3.0);
    const QRectF below(5.0, foot, width() - 10.0, row);
    drawWords(painter, below, Qt::AlignCenter, degrees(m_order_rad), 1.2 * letters, colours().setValue, true);
    drawWords(painter, below.translated(0.0, row), Qt::AlignCenter, tr("is %1").arg(degrees(m_angle_rad)),
              0.9 * letters, colours().text);
}

void AzimuthDial::take(QPointF p) {
    const QPointF d = p - circle().centre;
    if (std::hypot(d.x(), d.y()) < 3.0 * unit()) return;  // no direction there
    const double angle_rad = rounded_rad(std::atan2(d.x(), -d.y()));
    if (angle_rad != m_order_rad || !held()) turnTo(angle_rad);
}

void AzimuthDial::stepUp(int steps) { turnTo(m_order_rad + steps * kStep_rad); }

bool AzimuthDial::rest() {
    turnTo(0.0);
    return true;
}

}  // namespace sagara::ui::console
