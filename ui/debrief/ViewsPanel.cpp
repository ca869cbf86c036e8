#include "ui/debrief/ViewsPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "render/scene/Moment.h"
#include "ui/viewport/ViewportWidget.h"

namespace sagara::ui {

ViewsPanel::ViewsPanel(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("views"));
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(3);
}

QWidget* ViewsPanel::view(std::size_t index) {
    auto* const panel = new QWidget(this);
    auto* const layout = new QVBoxLayout(panel);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* const head = new QHBoxLayout;
    auto* const camera = new QComboBox(panel);
    camera->setObjectName(QStringLiteral("camera-%1").arg(index));
    camera->setAccessibleName(tr("Camera"));
    camera->setToolTip(
        tr("Camera. Drag to look round, wheel or B for glasses, double click ahead; free: W A S D R F"));
    const std::pair<QString, CameraKind> kinds[] = {{tr("Bridge"), CameraKind::Bridge},
                                                    {tr("Port wing"), CameraKind::WingPort},
                                                    {tr("Starboard wing"), CameraKind::WingStarboard},
                                                    {tr("Chase"), CameraKind::Chase},
                                                    {tr("Shore"), CameraKind::Shore},
                                                    {tr("Free"), CameraKind::Free}};
    for (const auto& [name, kind] : kinds) camera->addItem(name, static_cast<int>(kind));
    auto* const viewport = new ViewportWidget(m_stage->addViewport(320, 180), panel);
    for (const core::Place& place : m_world->area.places)
        if (place.kind == "entrance") viewport->rig().shore = place.position;
    const CameraKind first = index == 0 ? CameraKind::Chase : CameraKind::Bridge;
    camera->setCurrentIndex(camera->findData(static_cast<int>(first)));
    viewport->setCameraKind(first);
    connect(camera, &QComboBox::activated, viewport, [viewport, camera](int at) {
        viewport->setCameraKind(static_cast<CameraKind>(camera->itemData(at).toInt()));
    });
    head->addWidget(camera, 1);
    layout->addLayout(head);
    layout->addWidget(viewport, 1);
    m_views.push_back(viewport);
    m_panels.push_back(panel);
    if (index != 0) return panel;
    auto* const both = new QCheckBox(tr("Two views"), panel);
    both->setObjectName(QStringLiteral("two-views"));
    both->setToolTip(tr("A second view below, through a camera of its own"));
    head->addWidget(both);
    connect(both, &QCheckBox::toggled, this, [this](bool on) {
        if (m_panels.size() < 2)
            m_layout->addWidget(view(1), 1);  // costs time to draw: not before it is wanted
        m_panels[1]->setVisible(on);
    });
    return panel;
}

void ViewsPanel::setStage(render::Stage* stage, std::shared_ptr<const core::World> world) {
    m_stage = stage;
    m_world = std::move(world);
    if (std::exchange(m_filled, true)) return;
    if (m_stage == nullptr) {
        auto* const none = new QLabel(tr("No 3D views: this machine has no OpenGL 3.3."), this);
        none->setAlignment(Qt::AlignCenter);
        none->setWordWrap(true);
        m_layout->addWidget(none);
        return;
    }
    m_layout->addWidget(view(0), 1);
}

void ViewsPanel::draw(const core::Snapshot& snapshot, core::SimTime time) {
    if (m_stage == nullptr || !m_world) return;
    render::Moment moment = render::momentOf(snapshot);
    moment.time = time;
    for (ViewportWidget* view : m_views) {
        if (!view->isVisible()) continue;
        view->refresh();
        view->aim(*m_world, moment);
    }
    m_stage->drawSoon(std::move(moment));
}

}  // namespace sagara::ui
