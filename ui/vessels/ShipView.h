#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "core/exercise/World.h"
#include "render/scene/Stage.h"

class QCheckBox;
class QLabel;
class QTimer;

namespace sagara::ui {

class ViewportWidget;

/// Asks for the 3D scene, showing this world; null where there is none.
using StageFor = std::function<render::Stage*(const std::shared_ptr<const core::World>&)>;

/// A vessel seen from a camera that circles her slowly.
class ShipView final : public QWidget {
    Q_OBJECT

public:
    explicit ShipView(StageFor stageFor, QWidget* parent = nullptr);
    ~ShipView() override;

    /// Another ship, or none. The scene is asked for when the view is to be seen.
    void setVessel(std::optional<core::Vessel> vessel);
    void setTurning(bool turning);
    /// From the next vessel on.
    void setNight(bool night) { m_night = night; }
    /// What the scene draws otherwise than the document asks.
    QString remarks() const;

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void build();
    void draw();

    StageFor m_stageFor;
    std::optional<core::Vessel> m_vessel;
    std::shared_ptr<const core::World> m_world;
    render::Stage* m_stage = nullptr;
    render::Moment m_moment;
    ViewportWidget* m_view = nullptr;
    QLabel* m_none;
    QLabel* m_remark;
    QCheckBox* m_turn;
    QTimer* m_timer;
    double m_angle_rad = 0.6;
    double m_time_s = 0.0;
    bool m_night = false;
};

}  // namespace sagara::ui
