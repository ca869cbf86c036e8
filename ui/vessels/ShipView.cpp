#include "ui/vessels/ShipView.h"

#include <QCheckBox>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/Units.h"
#include "ui/vessels/StudioWorld.h"
#include "ui/viewport/ViewportWidget.h"

namespace sagara::ui {
namespace {

constexpr int kFrame_ms = 80;
constexpr double kTurn_radps = 0.12;  ///< a round in less than a minute

}  // namespace

ShipView::ShipView(StageFor stageFor, QWidget* parent)
    : QWidget(parent),
      m_stageFor(std::move(stageFor)),
      m_none(new QLabel(this)),
      m_remark(new QLabel(this)),
      m_turn(new QCheckBox(tr("Turn the view"), this)),
      m_timer(new QTimer(this)) {
    setObjectName(QStringLiteral("shipView"));
    m_turn->setChecked(true);
    m_turn->setToolTip(
        tr("The camera goes slowly round the ship. Drag to look aside, wheel to look closer."));
    m_none->setAlignment(Qt::AlignCenter);
    m_none->setWordWrap(true);
    m_remark->setWordWrap(true);
    m_remark->hide();
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_none, 1);
    layout->addWidget(m_remark);
    layout->addWidget(m_turn);
    m_timer->setInterval(kFrame_ms);
    connect(m_timer, &QTimer::timeout, this, &ShipView::draw);
}

ShipView::~ShipView() = default;

void ShipView::setVessel(std::optional<core::Vessel> vessel) {
    m_vessel = std::move(vessel);
    m_world.reset();
    if (isVisible()) build();
}

void ShipView::setTurning(bool turning) { m_turn->setChecked(turning); }

QString ShipView::remarks() const { return m_remark->text(); }

void ShipView::build() {
    m_timer->stop();
    m_stage = nullptr;
    if (m_vessel) {
        m_world = studioWorld(*m_vessel, m_night);
        m_moment = studioMoment(*m_world);
        m_stage = m_stageFor(m_world);
    }
    const bool drawn = m_stage != nullptr;
    m_none->setVisible(!drawn);
    m_turn->setVisible(drawn);
    m_remark->hide();
    m_none->setText(!m_vessel ? tr("Choose a vessel on the left.")
                              : tr("No 3D view: this machine has no OpenGL 3.3."));
    delete m_view;
    m_view = nullptr;
    if (!drawn) return;
    m_view = new ViewportWidget(m_stage->addViewport(320, 180), this);
    m_view->setCameraKind(CameraKind::Shore);
    m_view->setToolTip(tr("The ship as the scene draws her"));
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, m_view, 1);
    QString remark;
    for (const std::string& line : m_stage->remarks())
        remark += QString::fromStdString(line) + QLatin1Char('\n');
    m_remark->setText(remark.trimmed());
    m_remark->setVisible(!remark.isEmpty());
    m_timer->start();
    draw();
}

void ShipView::draw() {
    if (m_stage == nullptr || m_view == nullptr) return;
    const double dt_s = 0.001 * kFrame_ms;
    if (m_turn->isChecked()) m_angle_rad += kTurn_radps * dt_s;
    m_time_s += dt_s;
    m_moment.time = core::SimTime{static_cast<std::int64_t>(1e6 * m_time_s)};
    const core::Hull& hull = m_world->ships[0]->vessel.hull;
    // Far enough for her length to fill three quarters of the picture when seen abeam.
    const double off_m = 0.72 * hull.lengthOverall_m / std::tan(0.5 * kViewportFov_rad) + hull.beam_m;
    CameraRig& rig = m_view->rig();
    rig.shore = off_m * core::unitVector(m_angle_rad);
    rig.shoreUp_m = 0.16 * off_m + 2.0;
    m_view->refresh();
    m_view->aim(*m_world, m_moment);
    m_stage->drawSoon(m_moment);
}

void ShipView::showEvent(QShowEvent*) {
    // Another page may have had the scene in the meantime.
    QTimer::singleShot(0, this, [this] {
        if (isVisible()) build();
    });
}

void ShipView::hideEvent(QHideEvent*) { m_timer->stop(); }

}  // namespace sagara::ui
