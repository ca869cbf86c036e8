#include "ui/trainer/EventBoard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/trainer/WeatherBox.h"

namespace sagara::ui {
namespace {

QString fromStd(const std::string& utf8) { return QString::fromStdString(utf8); }

}  // namespace

EventBoard::EventBoard(ExerciseRun& run, QWidget* parent)
    : QWidget(parent), m_run(run), m_weather(new WeatherBox(run, this)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    addEvents(*layout);
    addFaults(*layout);
    layout->addWidget(m_weather);
    addDifficulty(*layout);
    layout->addStretch();
    refresh(*run.latest());
}

void EventBoard::addEvents(QVBoxLayout& layout) {
    const auto& events = m_run.world()->events;
    if (events.empty()) return;
    auto* const box = new QGroupBox(tr("Events of the scenario"), this);
    auto* const inside = new QVBoxLayout(box);
    for (std::size_t i = 0; i < events.size(); ++i) {
        auto* const button = new QPushButton(fromStd(events[i].title), box);
        button->setObjectName(fromStd("event-" + events[i].id));
        button->setToolTip(tr("Happens once, now"));
        connect(button, &QPushButton::clicked, this, [this, button, i] {
            m_run.give(0, core::TriggerOrder{static_cast<std::uint32_t>(i)});
            button->setEnabled(false);
        });
        inside->addWidget(button);
        m_events.push_back(button);
    }
    layout.addWidget(box);
}

void EventBoard::addFault(QVBoxLayout& layout, const QString& name, const QString& id, core::FaultOrder order,
                          std::function<bool(const core::OwnShipView&)> is) {
    auto* const check = new QCheckBox(name, this);
    check->setObjectName(id);
    check->setToolTip(tr("Comes when it is ticked, is mended when it is not"));
    const std::size_t index = m_faults.size();
    m_faults.push_back({check, std::move(is), -1});
    connect(check, &QCheckBox::toggled, this, [this, order, index](bool failed) {
        core::FaultOrder given = order;
        given.mended = !failed;
        m_faults[index].orderedAt = m_run.latest()->tick;
        m_run.give(0, given);
    });
    layout.addWidget(check);
}

void EventBoard::addFaults(QVBoxLayout& layout) {
    if (m_run.world()->ships.empty()) return;
    auto* const box = new QGroupBox(tr("Faults of %1").arg(fromStd(m_run.world()->ships[0]->name)), this);
    auto* const inside = new QVBoxLayout(box);
    using View = core::OwnShipView;
    addFault(*inside, tr("One steering pump"), QStringLiteral("fault-pump"),
             {core::Fault::SteeringPump, 1, false}, [](const View& ship) { return ship.pumpsFailed == 1; });
    addFault(*inside, tr("Both steering pumps"), QStringLiteral("fault-pumps"),
             {core::Fault::SteeringPump, 2, false}, [](const View& ship) { return ship.pumpsFailed >= 2; });
    addFault(*inside, tr("Rudder jammed"), QStringLiteral("fault-jam"), {core::Fault::SteeringJam, 0, false},
             [](const View& ship) { return ship.rudderJammed; });
    const auto& units = m_run.world()->ships[0]->vessel.propulsion.units;
    for (std::size_t i = 0; i < units.size(); ++i)
        addFault(*inside, tr("Engine, %1").arg(fromStd(units[i].id)),
                 QStringLiteral("fault-engine-%1").arg(i),
                 {core::Fault::Engine, static_cast<std::uint8_t>(i), false},
                 [i](const View& ship) { return i < ship.enginesFailed.size() && ship.enginesFailed[i]; });
    const auto& thrusters = m_run.world()->ships[0]->vessel.thrusters.units;
    for (std::size_t i = 0; i < thrusters.size(); ++i)
        addFault(*inside, tr("Thruster, %1").arg(fromStd(thrusters[i].id)),
                 QStringLiteral("fault-thruster-%1").arg(i),
                 {core::Fault::Thruster, static_cast<std::uint8_t>(i), false},
                 [i](const View& ship) { return i < ship.thrusters.size() && ship.thrusters[i].failed; });
    layout.addWidget(box);
}

void EventBoard::addDifficulty(QVBoxLayout& layout) {
    auto* const box = new QGroupBox(tr("Difficulty"), this);
    auto* const inside = new QVBoxLayout(box);
    m_level = new QComboBox(box);
    m_level->setObjectName(QStringLiteral("difficulty"));
    m_level->setToolTip(tr("Weather goes over in a minute, traffic and threats come and go"));
    for (int i = 1; i <= core::kLevels; ++i) m_level->addItem(tr("Level %1").arg(i), i);
    m_level->setCurrentIndex(m_run.latest()->level - 1);
    connect(m_level, &QComboBox::activated, this, [this](int index) {
        m_run.give(0, core::DifficultyOrder{static_cast<std::uint8_t>(index + 1)});
    });
    inside->addWidget(m_level);
    layout.addWidget(box);
}

void EventBoard::refresh(const core::Snapshot& now) {
    m_weather->refresh(now);
    const bool wentBack = now.tick < m_tick;
    m_tick = now.tick;
    if (wentBack) {
        m_seen = 0;
        for (QPushButton* button : m_events) button->setEnabled(true);
    }
    for (const core::Event& event : m_run.eventsFrom(m_seen)) {
        ++m_seen;
        const auto i = static_cast<std::size_t>(event.index);
        if (event.kind == core::EventKind::ScenarioEvent && i < m_events.size())
            m_events[i]->setEnabled(false);
        if (event.kind == core::EventKind::LevelChanged) {
            const QSignalBlocker quiet(m_level);
            m_level->setCurrentIndex(event.index - 1);
        }
    }
    if (now.ships.empty()) return;
    for (FaultBox& fault : m_faults) {
        // What was just ordered is carried out a tick later, or when a frozen exercise goes on.
        if (now.tick >= fault.orderedAt && now.tick <= fault.orderedAt + 2) continue;
        fault.orderedAt = -1;
        const QSignalBlocker quiet(fault.check);
        fault.check->setChecked(fault.is(now.ships[0]));
    }
}

}  // namespace sagara::ui
