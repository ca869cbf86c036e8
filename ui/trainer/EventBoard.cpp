#include "ui/trainer/EventBoard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

QString fromStd(const std::string& utf8) { return QString::fromStdString(utf8); }

}  // namespace

EventBoard::EventBoard(ExerciseRun& run, QWidget* parent) : QWidget(parent), m_run(run) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    addEvents(*layout);
    addFaults(*layout);
    addWeather(*layout);
    addDifficulty(*layout);
    layout->addStretch();
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
    }
    layout.addWidget(box);
}

void EventBoard::addFaults(QVBoxLayout& layout) {
    if (m_run.world()->ships.empty()) return;
    auto* const box = new QGroupBox(tr("Faults of %1").arg(fromStd(m_run.world()->ships[0]->name)), this);
    auto* const inside = new QVBoxLayout(box);
    const auto add = [&](const QString& name, const QString& id, core::Fault fault, std::uint8_t number) {
        auto* const check = new QCheckBox(name, box);
        check->setObjectName(id);
        connect(check, &QCheckBox::toggled, this, [this, fault, number](bool failed) {
            m_run.give(0, core::FaultOrder{fault, number, !failed});
        });
        inside->addWidget(check);
    };
    add(tr("One steering pump"), QStringLiteral("fault-pump"), core::Fault::SteeringPump, 1);
    add(tr("Rudder jammed"), QStringLiteral("fault-jam"), core::Fault::SteeringJam, 0);
    const auto& units = m_run.world()->ships[0]->vessel.propulsion.units;
    for (std::size_t i = 0; i < units.size(); ++i)
        add(tr("Engine, %1").arg(fromStd(units[i].id)), QStringLiteral("fault-engine-%1").arg(i),
            core::Fault::Engine, static_cast<std::uint8_t>(i));
    layout.addWidget(box);
}

QDoubleSpinBox* EventBoard::spin(double least, double most, double value, int decimals, const QString& unit) {
    auto* const spin = new QDoubleSpinBox(this);
    spin->setRange(least, most);
    spin->setDecimals(decimals);
    spin->setSuffix(QLatin1Char(' ') + unit);
    spin->setValue(value);
    spin->setToolTip(tr("%1 to %2 %3").arg(least).arg(most).arg(unit));
    return spin;
}

void EventBoard::addWeather(QVBoxLayout& layout) {
    auto* const box = new QGroupBox(tr("Weather"), this);
    auto* const form = new QFormLayout(box);
    const core::Weather w = m_run.latest()->weather;
    auto* const wind = spin(0.0, 100.0, w.wind.speed_mps / core::kKnot_mps, 0, tr("kn"));
    auto* const from =
        spin(0.0, 359.0, std::fmod(w.wind.windFrom_rad / core::kDegree_rad + 360.0, 360.0), 0, tr("°"));
    auto* const seen = spin(0.05, 30.0, w.visibility_m / core::kNauticalMile_m, 2, tr("M"));
    auto* const rain = spin(0.0, 100.0, 100.0 * w.rain, 0, tr("%"));
    auto* const ramp = spin(0.0, 3600.0, 60.0, 0, tr("s"));
    wind->setObjectName(QStringLiteral("wind"));
    auto* const apply = new QPushButton(tr("Change the weather"), box);
    apply->setObjectName(QStringLiteral("apply-weather"));
    form->addRow(tr("Wind"), wind);
    form->addRow(tr("from"), from);
    form->addRow(tr("Visibility"), seen);
    form->addRow(tr("Rain"), rain);
    form->addRow(tr("within"), ramp);
    form->addRow(apply);
    connect(apply, &QPushButton::clicked, this, [=, this] {
        core::WeatherOrder order;
        order.windSpeed_mps = wind->value() * core::kKnot_mps;
        order.windFrom_rad = from->value() * core::kDegree_rad;
        order.visibility_m = seen->value() * core::kNauticalMile_m;
        order.rain = 0.01 * rain->value();
        order.ramp_s = ramp->value();
        m_run.give(0, order);
    });
    layout.addWidget(box);
}

void EventBoard::addDifficulty(QVBoxLayout& layout) {
    auto* const box = new QGroupBox(tr("Difficulty"), this);
    auto* const inside = new QVBoxLayout(box);
    auto* const level = new QComboBox(box);
    level->setObjectName(QStringLiteral("difficulty"));
    level->setToolTip(tr("Weather goes over in a minute, traffic and threats come and go"));
    for (int i = 1; i <= core::kLevels; ++i) level->addItem(tr("Level %1").arg(i), i);
    level->setCurrentIndex(m_run.latest()->level - 1);
    connect(level, &QComboBox::activated, this, [this](int index) {
        m_run.give(0, core::DifficultyOrder{static_cast<std::uint8_t>(index + 1)});
    });
    inside->addWidget(level);
    layout.addWidget(box);
}

}  // namespace sagara::ui
