#include "ui/trainee/Lever.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace sagara::ui::console {

Lever::Lever(const QString& title, double shape, QWidget* parent) : Gauge(title, shape, parent) {
    setFocusPolicy(Qt::StrongFocus);
}

void Lever::prepareKnob(QPainter& painter) const {
    painter.setPen(QPen(hasFocus() ? colours().focus : colours().surface, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(colours().setValue);
}

void Lever::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    take(event->position());
    m_held = true;
}

void Lever::mouseMoveEvent(QMouseEvent* event) {
    if (m_held) take(event->position());
}

void Lever::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !rest()) Lever::mousePressEvent(event);
}

void Lever::wheelEvent(QWheelEvent* event) {
    const int steps = event->angleDelta().y() / 120;
    if (steps != 0) stepUp(steps);
    event->accept();
}

void Lever::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Up) return stepUp(1);
    if (event->key() == Qt::Key_Down) return stepUp(-1);
    Gauge::keyPressEvent(event);
}

}  // namespace sagara::ui::console
