#include "ui/viewport/ViewportWidget.h"

#include <QApplication>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

namespace sagara::ui {

ViewportWidget::ViewportWidget(std::shared_ptr<render::Viewport> viewport, QWidget* parent)
    : QWidget(parent), m_viewport(std::move(viewport)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("View"));
}

void ViewportWidget::setCameraKind(CameraKind kind) {
    const double axis_rad = m_camera.heading_rad + m_camera.yaw_rad;
    m_rig.lookAhead();
    // Free: goes on looking where the last camera looked.
    if (kind == CameraKind::Free) m_rig.turn(axis_rad, m_camera.tilt_rad);
    m_rig.kind = kind;
}

void ViewportWidget::aim(const core::World& world, const render::Moment& moment) {
    m_camera = m_rig.camera(world, moment, width(), height());
    m_viewport->setCamera(m_camera);
}

void ViewportWidget::refresh() {
    if (m_viewport->latest() != m_shown) update();
}

void ViewportWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const auto latest = m_viewport->latest();
    if (latest != m_shown) ++m_picturesShown;
    m_shown = latest;
    if (!m_shown) {
        painter.fillRect(rect(), Qt::black);
        painter.setPen(Qt::lightGray);
        const std::string trouble = m_viewport->trouble();
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         trouble.empty() ? tr("The view comes with the exercise.")
                                         : tr("No view: %1").arg(QString::fromStdString(trouble)));
        return;
    }
    const QImage image(m_shown->bgra.data(), m_shown->width, m_shown->height,
                       4 * static_cast<qsizetype>(m_shown->width), QImage::Format_RGB32);
    painter.drawImage(rect(), image);
}

void ViewportWidget::resizeEvent(QResizeEvent*) {
    const double ratio = devicePixelRatioF();
    m_viewport->resize(static_cast<int>(std::lround(ratio * width())),
                       static_cast<int>(std::lround(ratio * height())));
}

void ViewportWidget::mousePressEvent(QMouseEvent* event) {
    m_pressedAt = m_draggedTo = event->position().toPoint();
    m_dragged = false;
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton)) return;
    const QPoint at = event->position().toPoint();
    if ((at - m_pressedAt).manhattanLength() >= QApplication::startDragDistance()) m_dragged = true;
    if (!m_dragged) return;
    // What is under the mouse stays under it.
    const double radPerPixel = kViewportFov_rad / m_rig.magnification() / std::max(1, width());
    m_rig.turn(-radPerPixel * (at.x() - m_draggedTo.x()), radPerPixel * (at.y() - m_draggedTo.y()));
    m_draggedTo = at;
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
    if (m_dragged || event->button() != Qt::LeftButton) return;
    const QPointF at = event->position();
    Q_EMIT bearingTaken(bearingOf_rad(m_camera, at.x(), at.y(), width(), height()));
}

void ViewportWidget::mouseDoubleClickEvent(QMouseEvent*) {
    if (m_rig.kind != CameraKind::Free) m_rig.lookAhead();
    m_dragged = true;  // the second click takes no bearing
}

void ViewportWidget::wheelEvent(QWheelEvent* event) {
    m_rig.magnify(m_rig.magnification() * std::pow(1.25, event->angleDelta().y() / 120.0));
    event->accept();
}

void ViewportWidget::keyPressEvent(QKeyEvent* event) {
    constexpr double kTurn_rad = 0.05, kStep_m = 10.0;
    const bool free = m_rig.kind == CameraKind::Free;
    switch (event->key()) {
        case Qt::Key_Left:
            return m_rig.turn(-kTurn_rad / m_rig.magnification(), 0.0);
        case Qt::Key_Right:
            return m_rig.turn(kTurn_rad / m_rig.magnification(), 0.0);
        case Qt::Key_Up:
            return m_rig.turn(0.0, kTurn_rad / m_rig.magnification());
        case Qt::Key_Down:
            return m_rig.turn(0.0, -kTurn_rad / m_rig.magnification());
        case Qt::Key_Home:
            return m_rig.lookAhead();
        case Qt::Key_B:
            return m_rig.magnify(m_rig.magnification() > 1.0 ? 1.0 : 7.0);
        case Qt::Key_W:
            if (free) return m_rig.move(kStep_m, 0.0, 0.0);
            break;
        case Qt::Key_S:
            if (free) return m_rig.move(-kStep_m, 0.0, 0.0);
            break;
        case Qt::Key_A:
            if (free) return m_rig.move(0.0, -kStep_m, 0.0);
            break;
        case Qt::Key_D:
            if (free) return m_rig.move(0.0, kStep_m, 0.0);
            break;
        case Qt::Key_R:
            if (free) return m_rig.move(0.0, 0.0, 0.5 * kStep_m);
            break;
        case Qt::Key_F:
            if (free) return m_rig.move(0.0, 0.0, -0.5 * kStep_m);
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace sagara::ui
