#include "ui/trainee/AutopilotPanel.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::ui::console {

AutopilotPanel::AutopilotPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_ship(ship),
      m_mode(new QLabel(tr("Steering"), this)),
      m_hand(new QPushButton(tr("Hand"), this)),
      m_heading(new QPushButton(tr("Autopilot"), this)),
      m_set(new QSpinBox(this)) {
    m_hand->setObjectName(QStringLiteral("steer-hand"));
    m_hand->setToolTip(tr("Steer by hand; the rudder stays where it is. Any order of the wheel does it too"));
    m_heading->setObjectName(QStringLiteral("steer-heading"));
    m_heading->setToolTip(tr("The autopilot steers the heading set below"));
    auto* const group = new QButtonGroup(this);
    for (QPushButton* button : {m_hand, m_heading}) {
        button->setCheckable(true);
        group->addButton(button);
    }
    m_hand->setChecked(true);
    m_set->setObjectName(QStringLiteral("steer-set"));
    m_set->setRange(0, 359);
    m_set->setWrapping(true);
    m_set->setSuffix(tr("°T"));
    m_set->setAlignment(Qt::AlignCenter);
    m_set->setToolTip(tr("Heading to steer, 0 to 359 degrees true; Page Up and Page Down here: ten degrees"));
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(4, 4, 4, 4);
    grid->setSpacing(4);
    grid->addWidget(m_mode, 0, 0, 1, 4);
    grid->addWidget(m_hand, 1, 0, 1, 4);
    grid->addWidget(m_heading, 2, 0, 1, 4);
    grid->addWidget(m_set, 3, 0, 1, 4);
    int column = 0;
    for (const int step : {-10, -1, 1, 10}) {
        auto* const button = new QToolButton(this);
        button->setText(step > 0 ? QStringLiteral("+%1").arg(step) : QStringLiteral("−%1").arg(-step));
        button->setToolTip(tr("%1 degrees").arg(button->text()));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this,
                [this, step] { m_set->setValue((m_set->value() + step + 360) % 360); });
        grid->addWidget(button, 4, column++);
    }
    grid->setRowStretch(5, 1);
    connect(m_hand, &QPushButton::clicked, this, [this] {
        m_on = false;
        m_run.give(m_ship, core::AutopilotOrder{core::AutopilotMode::Off, 0.0});
    });
    connect(m_heading, &QPushButton::clicked, this, &AutopilotPanel::engage);
    connect(m_set, &QSpinBox::valueChanged, this, [this] {
        if (m_on) engage();
    });
}

void AutopilotPanel::engage() {
    m_on = true;
    const double grid_rad = m_set->value() * core::kDegree_rad - m_convergence_rad;
    m_run.give(m_ship, core::AutopilotOrder{core::AutopilotMode::Heading, grid_rad});
}

void AutopilotPanel::show(const core::OwnShipView& ship, const ShipReadings& readings) {
    m_convergence_rad = readings.convergence_rad;
    const QString mode = ship.pilotEngaged                                     ? tr("Pilot has the ship")
                         : ship.autopilot.mode == core::AutopilotMode::Track   ? tr("Steering: track")
                         : ship.autopilot.mode == core::AutopilotMode::Heading ? tr("Steering: heading")
                                                                               : tr("Steering: hand");
    if (m_mode->text() != mode) m_mode->setText(mode);
    if (!m_run.running()) return;
    m_on = ship.autopilot.mode == core::AutopilotMode::Heading;
    const bool track = ship.autopilot.mode == core::AutopilotMode::Track;
    m_heading->setChecked(m_on || track);
    m_hand->setChecked(ship.autopilot.mode == core::AutopilotMode::Off);
    if (m_on || m_set->hasFocus()) return;
    const QSignalBlocker quiet(m_set);  // ready to hold what she heads now
    m_set->setValue(static_cast<int>(std::lround(readings.heading_rad / core::kDegree_rad)) % 360);
}

}  // namespace sagara::ui::console
