#include "ui/trainer/ClassroomPanel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/trainer/PlanView.h"
#include "ui/trainer/TraceBoard.h"

namespace sagara::ui {

ClassroomPanel::ClassroomPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_ship(ship),
      m_plan(new PlanView(*run.world()->ships[ship], this)),
      m_traces(new TraceBoard(this)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(motionButtons());
    layout->addWidget(m_plan, 3);
    auto* const head = new QHBoxLayout;
    head->addWidget(new QLabel(tr("Traces of the last"), this));
    auto* const span = new QComboBox(this);
    span->setObjectName(QStringLiteral("trace-span"));
    span->setToolTip(tr("How far back the traces reach"));
    for (const int minutes : {1, 2, 5, 15}) span->addItem(tr("%1 min").arg(minutes), 60.0 * minutes);
    span->setCurrentIndex(1);
    connect(span, &QComboBox::activated, this,
            [this, span](int index) { m_traces->setSpan(span->itemData(index).toDouble()); });
    head->addWidget(span);
    head->addStretch();
    layout->addLayout(head);
    m_traces->setSeries(&m_series);
    layout->addWidget(m_traces, 4);
}

ClassroomPanel::~ClassroomPanel() = default;

QWidget* ClassroomPanel::motionButtons() {
    auto* const box = new QGroupBox(tr("Motions that are free"), this);
    box->setToolTip(tr("The others are held: no speed in them through the water, attitude as it is"));
    auto* const grid = new QGridLayout(box);
    grid->setSpacing(4);
    const std::array<QString, 6> names{tr("Surge"), tr("Sway"),  tr("Heave"),
                                       tr("Roll"),  tr("Pitch"), tr("Yaw")};
    const std::array<QString, 6> tips{tr("Ahead and astern"), tr("To port and starboard"),
                                      tr("Up and down"),      tr("About the keel line"),
                                      tr("Bow up and down"),  tr("Turning")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto* const button = new QPushButton(names[i], box);
        button->setCheckable(true);
        button->setChecked(true);
        button->setObjectName(QStringLiteral("free-%1").arg(i));
        button->setToolTip(tips[i]);
        connect(button, &QPushButton::clicked, this, [this] {
            std::uint8_t free = 0;
            for (std::size_t k = 0; k < m_motions.size(); ++k)
                if (m_motions[k]->isChecked()) free |= static_cast<std::uint8_t>(1U << k);
            order(free);
        });
        grid->addWidget(button, static_cast<int>(i / 3), static_cast<int>(i % 3));
        m_motions[i] = button;
    }
    m_all = new QPushButton(tr("All free"), box);
    m_all->setObjectName(QStringLiteral("free-all"));
    m_all->setToolTip(tr("The ship moves as she does at sea"));
    connect(m_all, &QPushButton::clicked, this, [this] { order(core::kAllMotions); });
    grid->addWidget(m_all, 0, 3, 2, 1);
    m_all->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    return box;
}

void ClassroomPanel::order(std::uint8_t free) {
    for (std::size_t i = 0; i < m_motions.size(); ++i) m_motions[i]->setChecked((free >> i & 1U) != 0);
    m_all->setEnabled(free != core::kAllMotions);
    m_orderedAt = m_run.latest()->tick;
    m_run.give(m_ship, core::FreezeMotionOrder{free});
}

void ClassroomPanel::setColours(PaletteName name) {
    m_plan->setColours(name);
    m_traces->setColours(name);
}

void ClassroomPanel::refresh(const core::Snapshot& now, const std::vector<ShownForce>& forces) {
    if (m_ship >= now.ships.size()) return;
    const core::OwnShipView& ship = now.ships[m_ship];
    m_series.add(now.time().seconds(), ship.motion);
    if (now.tick < m_orderedAt || now.tick > m_orderedAt + 2) {
        for (std::size_t i = 0; i < m_motions.size(); ++i)
            m_motions[i]->setChecked((ship.freeMotions >> i & 1U) != 0);
        m_all->setEnabled(!m_run.over() && ship.freeMotions != core::kAllMotions);
    }
    for (QPushButton* button : m_motions) button->setEnabled(!m_run.over());
    if (!isVisible()) return;
    m_plan->show(ship.motion, ship.rudder_rad, forces);
    m_traces->update();
}

}  // namespace sagara::ui
