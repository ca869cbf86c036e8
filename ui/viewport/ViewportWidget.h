#pragma once

#include <QPoint>
#include <QWidget>
#include <memory>

#include "render/scene/Stage.h"
#include "ui/viewport/CameraRig.h"

namespace sagara::ui {

/// Shows a viewport of the scene in a window of the station: mouse look (drag), glasses (wheel), the free
/// camera's keys (W, A, S, D, R, F), bearings (click). Owns no thread and no timer: whoever runs the exercise
/// calls `aim` before it asks the stage to draw, and `refresh` as often as the window is to be looked at.
class ViewportWidget final : public QWidget {
    Q_OBJECT

public:
    explicit ViewportWidget(std::shared_ptr<render::Viewport> viewport, QWidget* parent = nullptr);

    CameraRig& rig() { return m_rig; }
    void setCameraKind(CameraKind kind);
    /// Points the viewport's camera for this moment.
    void aim(const core::World& world, const render::Moment& moment);
    /// Repaints if there is a picture it has not shown yet.
    void refresh();

    /// How many different pictures have been painted, for figures and tests.
    int picturesShown() const { return m_picturesShown; }

    QSize sizeHint() const override { return {640, 360}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

Q_SIGNALS:
    /// A click into the view, without a drag: the bearing from the camera, grid north, radians.
    void bearingTaken(double bearing_rad);

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    std::shared_ptr<render::Viewport> m_viewport;
    std::shared_ptr<const render::Picture> m_shown;
    CameraRig m_rig;
    render::Camera m_camera;
    QPoint m_pressedAt, m_draggedTo;
    bool m_dragged = false;
    int m_picturesShown = 0;
};

}  // namespace sagara::ui
