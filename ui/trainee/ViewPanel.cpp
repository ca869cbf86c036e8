#include "ui/trainee/ViewPanel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"
#include "ui/viewport/ViewportWidget.h"

namespace sagara::ui::console {
namespace {

constexpr double kGlasses = 7.0;

}  // namespace

ViewPanel::ViewPanel(render::Stage* stage, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_looking(new QLabel(this)) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    if (stage == nullptr) {
        m_looking->setText(tr("No view: this machine has no OpenGL 3.3. Use radar and chart."));
        m_looking->setAlignment(Qt::AlignCenter);
        m_looking->setWordWrap(true);
        column->addWidget(m_looking);
        return;
    }
    m_view = new ViewportWidget(stage->addViewport(640, 360), this);
    m_view->setObjectName(QStringLiteral("view"));
    m_view->setToolTip(
        tr("Drag to look round, mouse wheel or B for glasses, double click ahead, click for a bearing"));
    m_view->rig().ship = ship;
    connect(m_view, &ViewportWidget::bearingTaken, this, &ViewPanel::bearingTaken);
    auto* const row = new QHBoxLayout;
    row->setContentsMargins(2, 2, 2, 0);
    row->setSpacing(2);
    auto* const places = new QButtonGroup(this);
    const std::tuple<QString, QString, CameraKind> stands[] = {
        {tr("Port wing"), tr("Look from the port wing of the bridge"), CameraKind::WingPort},
        {tr("Bridge"), tr("Look from the wheelhouse"), CameraKind::Bridge},
        {tr("Stbd wing"), tr("Look from the starboard wing of the bridge"), CameraKind::WingStarboard}};
    for (const auto& [text, tip, kind] : stands) {
        QToolButton* const stand = button(text, tip);
        stand->setCheckable(true);
        stand->setChecked(kind == CameraKind::Bridge);
        places->addButton(stand);
        connect(stand, &QToolButton::clicked, this, [this, where = kind] { m_view->setCameraKind(where); });
        row->addWidget(stand);
    }
    row->addSpacing(8);
    m_glasses = button(tr("Glasses"), tr("Binoculars, seven times (B; mouse wheel for more or less)"));
    m_glasses->setCheckable(true);
    connect(m_glasses, &QToolButton::clicked, this,
            [this](bool on) { m_view->rig().magnify(on ? kGlasses : 1.0); });
    row->addWidget(m_glasses);
    for (const auto& [text, tip, yaw_deg] :
         {std::tuple{tr("◀ 45°"), tr("Look 45° farther to port"), -45.0},
          std::tuple{tr("45° ▶"), tr("Look 45° farther to starboard"), 45.0}}) {
        QToolButton* const side = button(text, tip);
        connect(side, &QToolButton::clicked, this, [this, yaw = yaw_deg * core::kDegree_rad] { turn(yaw); });
        row->addWidget(side);
    }
    QToolButton* const ahead =
        button(tr("Ahead"), tr("Look ahead without glasses (double click in the view)"));
    connect(ahead, &QToolButton::clicked, this, [this] { m_view->rig().lookAhead(); });
    row->addWidget(ahead);
    row->addStretch();
    row->addWidget(m_looking);
    column->addLayout(row);
    column->addWidget(m_view, 1);
}

QToolButton* ViewPanel::button(const QString& text, const QString& tip) {
    auto* const made = new QToolButton(this);
    made->setText(text);
    made->setToolTip(tip);
    return made;
}

void ViewPanel::aim(const core::World& world, const render::Moment& moment) {
    if (m_view == nullptr) return;
    m_view->refresh();
    m_view->aim(world, moment);
}

void ViewPanel::turn(double yaw_rad) {
    if (m_view != nullptr) m_view->rig().turn(yaw_rad, 0.0);
}

void ViewPanel::show(const ShipReadings& readings) {
    if (m_view == nullptr) return;
    const double looks_rad = core::wrapTwoPi(readings.heading_rad + m_view->rig().yaw_rad());
    const QString text = tr("looking %1°T, x%2")
                             .arg(chart::bearing(looks_rad / core::kDegree_rad))
                             .arg(m_view->rig().magnification(), 0, 'f', 0);
    if (m_looking->text() != text) m_looking->setText(text);
    m_glasses->setChecked(m_view->rig().magnification() > 1.01);
}

}  // namespace sagara::ui::console
