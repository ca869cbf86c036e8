#pragma once

#include <QWidget>

#include "render/scene/Stage.h"
#include "ui/run/ExerciseRun.h"
#include "ui/trainee/ShipReadings.h"
#include "ui/viewport/CameraRig.h"

class QLabel;
class QToolButton;

namespace sagara::ui {
class ViewportWidget;
}

namespace sagara::ui::console {

/// The view out of the wheelhouse or from a wing, with glasses. No camera that is not on board.
class ViewPanel final : public QWidget {
    Q_OBJECT

public:
    /// `stage` may be null: then it says why there is no view.
    ViewPanel(render::Stage* stage, std::size_t ship, QWidget* parent = nullptr);
    /// Points the camera; before the stage draws.
    void aim(const core::World& world, const render::Moment& moment);
    void show(const ShipReadings& readings);
    using QWidget::show;
    bool hasView() const { return m_view != nullptr; }
    void turn(double yaw_rad);

Q_SIGNALS:
    void bearingTaken(double grid_rad);

private:
    QToolButton* button(const QString& text, const QString& tip);

    ViewportWidget* m_view = nullptr;
    QLabel* m_looking;
    QToolButton* m_glasses = nullptr;
};

}  // namespace sagara::ui::console
