#pragma once

#include <QWidget>
#include <vector>

#include "core/exercise/Snapshot.h"
#include "render/scene/Stage.h"

class QComboBox;
class QVBoxLayout;

namespace sagara::ui {

class ViewportWidget;

/// One or two views of a moment through any camera.
class ViewsPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ViewsPanel(QWidget* parent = nullptr);

    /// `stage` may be null: then it says that there are no views.
    void setStage(render::Stage* stage, std::shared_ptr<const core::World> world);
    void draw(const core::Snapshot& snapshot, core::SimTime time);

private:
    QWidget* view(std::size_t index);

    render::Stage* m_stage = nullptr;
    std::shared_ptr<const core::World> m_world;
    QVBoxLayout* m_layout;
    std::vector<ViewportWidget*> m_views;
    std::vector<QWidget*> m_panels;
    bool m_filled = false;
};

}  // namespace sagara::ui
