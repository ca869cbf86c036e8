#include "ui/trainee/Gauge.h"

#include <QFontInfo>
#include <QPolygonF>
#include <QTransform>
#include <algorithm>
#include <cmath>

namespace sagara::ui::console {

Gauge::Gauge(const QString& title, double shape, QWidget* parent)
    : QWidget(parent), m_title(title), m_shape(shape) {
    setAccessibleName(title);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMinimumSize(60, 60);
}

void Gauge::setColours(PaletteName name) {
    m_palette = name;
    update();
}

QRectF Gauge::drawFrame(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
    painter.setPen(QPen(colours().line, 1.0));
    painter.setBrush(colours().surface);
    painter.drawRoundedRect(box, 4.0, 4.0);
    const double letters_px = QFontInfo(font()).pixelSize();
    const QRectF title(box.left() + 7.0, box.top() + 3.0, box.width() - 14.0, 1.35 * letters_px);
    drawWords(painter, title, Qt::AlignLeft | Qt::AlignVCenter, m_title, letters_px, colours().quietText);
    return box.adjusted(7.0, 4.0 + 1.35 * letters_px, -7.0, -4.0);
}

void Gauge::drawWords(QPainter& painter, const QRectF& box, Qt::Alignment alignment, const QString& words,
                      double size_px, const QColor& colour, bool bold) const {
    QFont letters = font();
    letters.setBold(bold);
    letters.setPixelSize(std::max(8, static_cast<int>(std::lround(size_px))));
    const double wide = QFontMetricsF(letters).horizontalAdvance(words);
    if (wide > box.width() && wide > 0.0)
        letters.setPixelSize(std::max(8, static_cast<int>(size_px * box.width() / wide)));
    painter.setFont(letters);
    painter.setPen(colour);
    painter.drawText(box, static_cast<int>(alignment) | Qt::TextDontClip, words);
}

QString sided(double value, int decimals) {
    const QString number = QString::number(std::abs(value), 'f', decimals);
    if (number.toDouble() == 0.0) return number;
    return (value < 0.0 ? QStringLiteral("P ") : QStringLiteral("S ")) + number;
}

QPolygonF pointerAt(QPointF tip, double size, double towards_deg) {
    QTransform turn;
    turn.translate(tip.x(), tip.y());
    turn.rotate(towards_deg);
    return turn.map(QPolygonF{QPointF(0.0, 0.0), QPointF(0.6 * size, size), QPointF(-0.6 * size, size)});
}

}  // namespace sagara::ui::console
