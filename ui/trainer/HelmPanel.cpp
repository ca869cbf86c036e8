#include "ui/trainer/HelmPanel.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <array>
#include <cmath>

#include "core/base/Units.h"
#include "ui/trainer/DriveSliders.h"

namespace sagara::ui {
namespace {

using core::TelegraphStep;

/// From full ahead, at the top, to full astern.
QString stepName(TelegraphStep step) {
    switch (step) {
        case TelegraphStep::FullAhead:
            return HelmPanel::tr("Full ahead");
        case TelegraphStep::HalfAhead:
            return HelmPanel::tr("Half ahead");
        case TelegraphStep::SlowAhead:
            return HelmPanel::tr("Slow ahead");
        case TelegraphStep::DeadSlowAhead:
            return HelmPanel::tr("Dead slow ahead");
        case TelegraphStep::Stop:
            return HelmPanel::tr("Stop");
        case TelegraphStep::DeadSlowAstern:
            return HelmPanel::tr("Dead slow astern");
        case TelegraphStep::SlowAstern:
            return HelmPanel::tr("Slow astern");
        case TelegraphStep::HalfAstern:
            return HelmPanel::tr("Half astern");
        case TelegraphStep::FullAstern:
            return HelmPanel::tr("Full astern");
    }
    return {};
}

/// The step nearest to an ordered shaft speed.
int nearestStep(const core::TelegraphTable& table, double shaft_rps) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < table.size(); ++i)
        if (std::abs(table[i] - shaft_rps) < std::abs(table[best] - shaft_rps)) best = i;
    return static_cast<int>(best);
}

}  // namespace

HelmPanel::HelmPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_ship(ship),
      m_pilot(new QCheckBox(tr("The scripted pilot has the ship"), this)),
      m_rudder(new QSlider(Qt::Horizontal, this)),
      m_order(new QLabel(this)) {
    const core::Vessel& vessel = run.world()->ships[ship]->vessel;
    auto* const form = new QFormLayout(this);
    form->setContentsMargins(8, 8, 8, 8);
    m_pilot->setObjectName(QStringLiteral("pilot"));
    m_pilot->setEnabled(!run.world()->pilot.empty());
    if (run.world()->pilot.empty()) m_pilot->setToolTip(tr("This scenario has no pilot"));
    form->addRow(m_pilot);

    const int limit_deg = static_cast<int>(std::lround(vessel.steering.limit_rad / core::kDegree_rad));
    m_rudder->setObjectName(QStringLiteral("rudder"));
    m_rudder->setRange(-limit_deg, limit_deg);
    m_rudder->setTickPosition(QSlider::TicksBelow);
    m_rudder->setTickInterval(5);
    m_rudder->setPageStep(5);
    m_rudder->setToolTip(tr("Rudder order, %1° each way").arg(limit_deg));
    auto* const midships = new QPushButton(tr("Midships"), this);
    auto* const order = new QHBoxLayout;
    order->addWidget(m_order);
    order->addStretch();
    order->addWidget(midships);
    form->addRow(tr("Rudder"), order);
    form->addRow(m_rudder);  // all the width there is

    const auto& units = vessel.propulsion.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        auto* const telegraph = new QComboBox(this);
        telegraph->setObjectName(QStringLiteral("telegraph-%1").arg(i));
        telegraph->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        telegraph->setMinimumContentsLength(10);  // the panel is narrow
        for (int step = static_cast<int>(core::kTelegraphSteps) - 1; step >= 0; --step)
            telegraph->addItem(stepName(static_cast<TelegraphStep>(step)), step);
        form->addRow(tr("Telegraph, %1").arg(QString::fromStdString(units[i].id)), telegraph);
        connect(telegraph, &QComboBox::activated, this, [this, telegraph, i](int index) {
            const auto step = static_cast<TelegraphStep>(telegraph->itemData(index).toInt());
            m_run.give(m_ship, core::TelegraphOrder{static_cast<std::uint8_t>(i), step});
        });
        m_telegraphs.push_back(telegraph);
    }
    m_drives = new DriveSliders(run, ship, *form);
    addThrusters(*form);
    connect(m_pilot, &QCheckBox::toggled, this,
            [this](bool on) { m_run.give(m_ship, core::PilotOrder{on}); });
    connect(m_rudder, &QSlider::valueChanged, this,
            [this](int order_deg) { m_run.give(m_ship, core::HelmOrder{order_deg * core::kDegree_rad}); });
    connect(midships, &QPushButton::clicked, this, [this] {
        m_rudder->setValue(0);
        m_run.give(m_ship, core::HelmOrder{0.0});
    });
    refresh();
}

void HelmPanel::addThrusters(QFormLayout& form) {
    const auto& units = m_run.world()->ships[m_ship]->vessel.thrusters.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        auto* const lever = new QSlider(Qt::Horizontal, this);
        lever->setObjectName(QStringLiteral("thruster-%1").arg(i));
        lever->setRange(-10, 10);
        lever->setPageStep(2);
        lever->setTickPosition(QSlider::TicksBelow);
        lever->setTickInterval(5);
        lever->setToolTip(tr("Thrust in tenths of full, starboard to the right"));
        form.addRow(tr("Thruster, %1").arg(QString::fromStdString(units[i].id)), lever);
        connect(lever, &QSlider::valueChanged, this, [this, i](int tenths) {
            m_run.give(m_ship, core::ThrusterOrder{static_cast<std::uint8_t>(i), 0.1 * tenths});
        });
        m_thrusters.push_back(lever);
    }
}

void HelmPanel::refresh() {
    const auto now = m_run.latest();
    if (m_ship >= now->ships.size()) return;
    const core::OwnShipView& ship = now->ships[m_ship];
    const QSignalBlocker quiet[] = {QSignalBlocker(m_pilot), QSignalBlocker(m_rudder)};
    // An order not yet carried out must not be undone by the display of the last.
    const bool follows = m_run.running() || now->tick != m_tick;
    m_tick = now->tick;
    if (!m_rudder->isSliderDown() && follows)
        m_rudder->setValue(static_cast<int>(std::lround(ship.rudderOrder_rad / core::kDegree_rad)));
    if (follows) m_pilot->setChecked(ship.pilotEngaged);
    const int order_deg = m_rudder->value();
    m_order->setText(order_deg == 0  ? tr("0°")
                     : order_deg < 0 ? tr("P %1°").arg(-order_deg)
                                     : tr("S %1°").arg(order_deg));
    const auto& table = m_run.world()->ships[m_ship]->vessel.propulsion.telegraph_rps;
    for (std::size_t i = 0; i < std::min(m_telegraphs.size(), ship.shaftOrders_rps.size()); ++i) {
        if (m_telegraphs[i]->view()->isVisible() || !follows) continue;
        const int step = nearestStep(table, ship.shaftOrders_rps[i]);
        m_telegraphs[i]->setCurrentIndex(m_telegraphs[i]->findData(step));
    }
    m_drives->refresh(ship, follows);
    for (std::size_t i = 0; i < std::min(m_thrusters.size(), ship.thrusters.size()); ++i) {
        if (m_thrusters[i]->isSliderDown() || !follows) continue;
        const QSignalBlocker still(m_thrusters[i]);
        m_thrusters[i]->setValue(static_cast<int>(std::lround(10.0 * ship.thrusters[i].order)));
    }
}

}  // namespace sagara::ui
