#include "ui/trainee/ControlRow.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/trainee/AnchorPanel.h"
#include "ui/trainee/AutopilotPanel.h"
#include "ui/trainee/Bearings.h"
#include "ui/trainee/HelmWheel.h"
#include "ui/trainee/LinePanel.h"
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

/// "pitch 60 %  045°  8 starts", each where the ship has it.
QString noteOf(const core::PropulsionUnit& unit, const core::DriveView& drive) {
    QStringList parts;
    if (unit.pitch) parts << ControlRow::tr("pitch %1 %").arg(std::lround(100.0 * drive.pitch));
    if (unit.azimuth)
        parts << ControlRow::tr("%1°").arg(
            std::lround(core::wrapTwoPi(drive.azimuth_rad) / core::kDegree_rad) % 360, 3, 10,
            QLatin1Char('0'));
    if (drive.startsLeft) parts << ControlRow::tr("air %1").arg(static_cast<int>(*drive.startsLeft));
    return parts.join(QStringLiteral("  "));
}

}  // namespace

ControlRow::ControlRow(ExerciseRun& run, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_run(run), m_ship(static_cast<std::uint8_t>(ship)) {
    const core::Vessel& vessel = run.world()->ships[ship]->vessel;
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3);
    const auto& units = vessel.propulsion.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        auto* const telegraph =
            new ShaftTelegraph(spokenName(units[i].id), vessel.propulsion.telegraph_rps, this);
        telegraph->setObjectName(QStringLiteral("telegraph-%1").arg(i));
        connect(telegraph, &ShaftTelegraph::ordered, this, [this, i](core::TelegraphStep step) {
            m_lastOrder.start();
            m_run.give(m_ship, core::TelegraphOrder{static_cast<std::uint8_t>(i), step});
            Q_EMIT telegraphGiven(static_cast<int>(i), step);
        });
        row->addWidget(telegraph);
        m_telegraphs.push_back(telegraph);
    }
    m_wheel = new HelmWheel(vessel.steering.limit_rad, this);
    connect(m_wheel, &HelmWheel::ordered, this, &ControlRow::setHelm);
    row->addWidget(m_wheel);
    if (!vessel.thrusters.units.empty()) row->addWidget(m_thrusterColumn = makeThrusters());
    m_autopilot = new AutopilotPanel(run, m_ship, this);
    row->addWidget(m_autopilot);
    addDeck();
    row->addWidget(m_deck, 1);
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
            m_lastOrder.start();
            m_run.give(m_ship, core::ThrusterOrder{static_cast<std::uint8_t>(i), share});
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
    for (ShaftTelegraph* telegraph : m_telegraphs) telegraph->setFixedWidth(static_cast<int>(124.0 * unit));
    const bool thrusters = m_thrusterColumn != nullptr;  // the deck needs its room
    m_wheel->setFixedWidth(static_cast<int>((thrusters ? 244.0 : 270.0) * unit));
    if (thrusters) m_thrusterColumn->setFixedWidth(static_cast<int>(128.0 * unit));
    m_autopilot->setFixedWidth(static_cast<int>(140.0 * unit));
}

void ControlRow::setHelm(double rudder_rad) {
    m_lastOrder.start();
    m_wheel->setOrder(rudder_rad);
    m_run.give(m_ship, core::HelmOrder{rudder_rad});
    Q_EMIT helmGiven(rudder_rad);
}

void ControlRow::setTelegraph(int shaft, core::TelegraphStep step) {
    if (shaft >= 0 && static_cast<std::size_t>(shaft) < m_telegraphs.size())
        m_telegraphs[static_cast<std::size_t>(shaft)]->moveTo(step);
}

void ControlRow::setThruster(int thruster, double share) {
    if (thruster < 0 || static_cast<std::size_t>(thruster) >= m_thrusters.size()) return;
    m_lastOrder.start();
    m_thrusters[static_cast<std::size_t>(thruster)]->setOrder(share);
    m_run.give(m_ship, core::ThrusterOrder{static_cast<std::uint8_t>(thruster), share});
    Q_EMIT thrusterGiven(thruster, share);
}

void ControlRow::turnHelmBy(double rudder_rad) { m_wheel->turnTo(m_wheel->order_rad() + rudder_rad); }

void ControlRow::midships() { m_wheel->turnTo(0.0); }

void ControlRow::moveTelegraphs(int steps) {
    for (ShaftTelegraph* telegraph : m_telegraphs) telegraph->moveBy(steps);
}

void ControlRow::show(const core::Snapshot& now, const ShipReadings& readings) {
    const core::OwnShipView& own = now.ships[m_ship];
    const bool settled = !m_lastOrder.isValid() || (m_run.running() && m_lastOrder.elapsed() > kOnItsWay_ms);
    m_wheel->setRudder(own.rudder_rad);
    if (settled) m_wheel->setOrder(own.rudderOrder_rad);
    for (std::size_t i = 0; i < std::min(m_telegraphs.size(), own.shafts_rps.size()); ++i) {
        m_telegraphs[i]->setShaft(own.shafts_rps[i]);
        if (settled) m_telegraphs[i]->setOrder(own.shaftOrders_rps[i]);
        if (i < own.drives.size())
            m_telegraphs[i]->setNote(
                noteOf(m_run.world()->ships[m_ship]->vessel.propulsion.units[i], own.drives[i]));
    }
    for (std::size_t i = 0; i < std::min(m_thrusters.size(), own.thrusters.size()); ++i) {
        m_thrusters[i]->setThrust(own.thrusters[i].share);
        if (settled) m_thrusters[i]->setOrder(own.thrusters[i].order);
    }
    m_autopilot->show(own, readings);
    m_lines->show(own);
    m_anchors->show(own);
}

}  // namespace sagara::ui::console
