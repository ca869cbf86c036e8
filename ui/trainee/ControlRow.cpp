#include "ui/trainee/ControlRow.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/trainee/AnchorPanel.h"
#include "ui/trainee/AutopilotPanel.h"
#include "ui/trainee/AzimuthDial.h"
#include "ui/trainee/Bearings.h"
#include "ui/trainee/DriveControls.h"
#include "ui/trainee/HelmWheel.h"
#include "ui/trainee/LinePanel.h"
#include "ui/trainee/PitchLever.h"
#include "ui/trainee/ReportPanel.h"
#include "ui/trainee/ShaftTelegraph.h"
#include "ui/trainee/ThrusterLever.h"

namespace sagara::ui::console {
namespace {

constexpr qint64 kOnItsWay_ms = 400;

QWidget* scrolled(QWidget* inside) {
    auto* const area = new QScrollArea;
    area->setWidget(inside);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    return area;
}

}  // namespace

ControlRow::ControlRow(ExerciseRun& run, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_run(run), m_ship(static_cast<std::uint8_t>(ship)) {
    const core::Vessel& vessel = run.world()->ships[ship]->vessel;
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3);
    for (std::size_t i = 0; i < vessel.propulsion.units.size(); ++i) row->addWidget(addDrive(i));
    m_wheel = new HelmWheel(vessel.steering.limit_rad, this);
    connect(m_wheel, &HelmWheel::ordered, this, &ControlRow::setHelm);
    row->addWidget(m_wheel);
    if (!vessel.thrusters.units.empty()) row->addWidget(m_thrusterColumn = makeThrusters());
    m_autopilot = new AutopilotPanel(run, m_ship, this);
    row->addWidget(m_autopilot);
    addDeck();
    row->addWidget(m_deck, 1);
}

QWidget* ControlRow::addDrive(std::size_t i) {
    const auto shaft = static_cast<std::uint8_t>(i);
    auto* const drive = new DriveControls(m_run.world()->ships[m_ship]->vessel.propulsion, i, this);
    m_drives.push_back(drive);
    ShaftTelegraph& telegraph = drive->telegraph();
    connect(&telegraph, &ShaftTelegraph::ordered, this, [this, shaft](core::TelegraphStep step) {
        give(core::TelegraphOrder{shaft, step});
        Q_EMIT telegraphGiven(shaft, step);
    });
    if (PitchLever* const pitch = drive->pitch()) {
        connect(pitch, &PitchLever::ordered, this, [this, shaft](double order) {
            give(core::PitchOrder{shaft, order});
        });
        connect(pitch, &PitchLever::givenBack, &telegraph,
                [&telegraph] { telegraph.moveTo(telegraph.step()); });
    }
    if (AzimuthDial* const dial = drive->azimuth())
        connect(dial, &AzimuthDial::ordered, this, [this, shaft](double angle_rad) {
            give(core::AzimuthOrder{shaft, angle_rad});
        });
    return drive;
}

void ControlRow::give(core::Order order) {
    m_lastOrder.start();
    m_run.give(m_ship, std::move(order));
}

DriveControls* ControlRow::drive(int shaft) {
    const auto i = static_cast<std::size_t>(shaft);
    return shaft >= 0 && i < m_drives.size() ? m_drives[i] : nullptr;
}

/// One above the other, bow on top, port on the left.
QWidget* ControlRow::makeThrusters() {
    auto* const side = new QWidget(this);
    auto* const column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    const auto& units = m_run.world()->ships[m_ship]->vessel.thrusters.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        auto* const lever = new ThrusterLever(
            tr("%1 thruster").arg(spokenName(units[i].id)),
            units[i].position.x_m > 0.0 ? tr("J port, K stop, L starboard") : tr("the same with Shift"),
            side);
        lever->setObjectName(QStringLiteral("thruster-%1").arg(i));
        connect(lever, &ThrusterLever::ordered, this, [this, i](double share) {
            give(core::ThrusterOrder{static_cast<std::uint8_t>(i), share});
            Q_EMIT thrusterGiven(static_cast<int>(i), share);
        });
        column->addWidget(lever);
        m_thrusters.push_back(lever);
    }
    return side;
}

void ControlRow::addDeck() {
    m_deck = new QTabWidget(this);
    m_deck->setObjectName(QStringLiteral("deck"));
    m_deck->setDocumentMode(true);
    m_lines = new LinePanel(m_run, m_ship, this);
    m_anchors = new AnchorPanel(m_run, m_ship, this);
    m_bearings = new BearingList(this);
    m_deck->addTab(scrolled(m_lines), tr("Lines"));
    m_deck->addTab(scrolled(m_anchors), tr("Anchors"));
    m_deck->addTab(m_bearings, tr("Bearings"));
    m_deck->addTab(scrolled(new ReportPanel(m_run, m_ship, this)), tr("Report"));
    if (m_run.world()->ships[m_ship]->lines.empty()) m_deck->setCurrentIndex(1);
}

void ControlRow::setColours(PaletteName name) {
    for (Gauge* gauge : findChildren<Gauge*>()) gauge->setColours(name);
}

void ControlRow::setUnit(double unit) {
    bool more = false;  // the deck needs its room
    for (DriveControls* drive : m_drives) {
        drive->setUnit(unit);
        more |= drive->pitch() != nullptr || drive->azimuth() != nullptr;
    }
    const bool thrusters = m_thrusterColumn != nullptr;
    m_wheel->setFixedWidth(static_cast<int>((more ? 216.0 : thrusters ? 244.0 : 270.0) * unit));
    if (thrusters) m_thrusterColumn->setFixedWidth(static_cast<int>(128.0 * unit));
    m_autopilot->setFixedWidth(static_cast<int>(140.0 * unit));
}

void ControlRow::setHelm(double rudder_rad) {
    m_wheel->setOrder(rudder_rad);
    give(core::HelmOrder{rudder_rad});
    Q_EMIT helmGiven(rudder_rad);
}

void ControlRow::setTelegraph(int shaft, core::TelegraphStep step) {
    if (DriveControls* const of = drive(shaft)) of->telegraph().moveTo(step);
}

void ControlRow::setPitch(int shaft, double pitch) {
    DriveControls* const of = drive(shaft);
    if (of == nullptr || of->pitch() == nullptr) return;
    const double within = of->pitch()->within(pitch);
    of->pitch()->setOrder(within, true);
    give(core::PitchOrder{static_cast<std::uint8_t>(shaft), within});
}

void ControlRow::setAzimuth(int shaft, double angle_rad) {
    DriveControls* const of = drive(shaft);
    if (of == nullptr || of->azimuth() == nullptr) return;
    of->azimuth()->setOrder(angle_rad);
    give(core::AzimuthOrder{static_cast<std::uint8_t>(shaft), angle_rad});
}

void ControlRow::shiftPitch(int shaft, int steps) {
    DriveControls* const of = drive(shaft);
    if (of != nullptr && of->pitch() != nullptr) of->pitch()->moveBy(steps);
}

void ControlRow::shiftAzimuth(int shaft, int steps) {
    DriveControls* const of = drive(shaft);
    if (of != nullptr && of->azimuth() != nullptr) of->azimuth()->turnBy(steps);
}

void ControlRow::setThruster(int thruster, double share) {
    if (thruster < 0 || static_cast<std::size_t>(thruster) >= m_thrusters.size()) return;
    m_thrusters[static_cast<std::size_t>(thruster)]->setOrder(share);
    give(core::ThrusterOrder{static_cast<std::uint8_t>(thruster), share});
    Q_EMIT thrusterGiven(thruster, share);
}

void ControlRow::turnHelmBy(double rudder_rad) { m_wheel->turnTo(m_wheel->order_rad() + rudder_rad); }

void ControlRow::midships() { m_wheel->turnTo(0.0); }

void ControlRow::moveTelegraphs(int steps) {
    for (DriveControls* drive : m_drives) drive->telegraph().moveBy(steps);
}

void ControlRow::show(const core::Snapshot& now, const ShipReadings& readings) {
    const core::OwnShipView& own = now.ships[m_ship];
    const bool settled = !m_lastOrder.isValid() || (m_run.running() && m_lastOrder.elapsed() > kOnItsWay_ms);
    m_wheel->setRudder(own.rudder_rad);
    if (settled) m_wheel->setOrder(own.rudderOrder_rad);
    for (DriveControls* drive : m_drives) drive->show(own, settled);
    for (std::size_t i = 0; i < std::min(m_thrusters.size(), own.thrusters.size()); ++i) {
        m_thrusters[i]->setThrust(own.thrusters[i].share);
        if (settled) m_thrusters[i]->setOrder(own.thrusters[i].order);
    }
    m_autopilot->show(own, readings);
    m_lines->show(own);
    m_anchors->show(own);
}

}  // namespace sagara::ui::console
