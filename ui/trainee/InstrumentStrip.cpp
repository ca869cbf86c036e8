#include "ui/trainee/InstrumentStrip.h"

#include <QHBoxLayout>

#include "ui/run/RunTexts.h"
#include "ui/trainee/ClockGauge.h"
#include "ui/trainee/DepthGauge.h"
#include "ui/trainee/HeadingGauge.h"
#include "ui/trainee/RudderGauge.h"
#include "ui/trainee/ShaftGauge.h"
#include "ui/trainee/SpeedGauge.h"
#include "ui/trainee/WindGauge.h"

namespace sagara::ui::console {
namespace {

std::vector<QString> shaftNames(const core::Vessel& vessel) {
    std::vector<QString> names;
    for (const core::PropulsionUnit& unit : vessel.propulsion.units)
        names.push_back(QString::fromStdString(unit.id));
    return names;
}

QString zoneName(const core::Area& area) {
    const int minutes = area.utcOffset_min;
    return QStringLiteral("local, UTC%1%2:%3")
        .arg(minutes < 0 ? QStringLiteral("−") : QStringLiteral("+"))
        .arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0'))
        .arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

InstrumentStrip::InstrumentStrip(const core::World& world, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_world(world), m_ship(ship) {
    const core::Vessel& vessel = world.ships[ship]->vessel;
    m_heading = new HeadingGauge(this);
    m_speed = new SpeedGauge(this);
    m_rudder = new RudderGauge(vessel.steering.limit_rad, this);
    m_shafts = new ShaftGauge(shaftNames(vessel), vessel.propulsion.telegraph_rps.back(), this);
    m_wind = new WindGauge(this);
    m_depth = new DepthGauge(this);
    m_clock = new ClockGauge(zoneName(world.area), this);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3);
    for (Gauge* gauge :
         std::initializer_list<Gauge*>{m_heading, m_speed, m_rudder, m_shafts, m_wind, m_depth, m_clock})
        row->addWidget(gauge, gauge->sizeHint().width());
}

void InstrumentStrip::setColours(PaletteName name) {
    for (Gauge* gauge : findChildren<Gauge*>()) gauge->setColours(name);
}

void InstrumentStrip::show(const core::Snapshot& now, const ShipReadings& r, double depthAlarm_m) {
    const core::OwnShipView& own = now.ships[m_ship];
    m_heading->setCourse(r.course_rad);
    std::optional<double> ordered;
    if (own.autopilot.mode == core::AutopilotMode::Heading)
        ordered = own.autopilot.setHeading_rad + r.convergence_rad;
    m_heading->setOrdered(ordered);
    m_heading->setHeading(r.heading_rad, r.turn_radps);
    m_speed->setOverGround(r.overGround_mps, r.course_rad);
    m_speed->setThroughWater(r.ahead_mps, r.toStarboard_mps);
    m_rudder->setRudder(own.rudder_rad, own.rudderOrder_rad);
    const auto& units = m_world.ships[m_ship]->vessel.propulsion.units;
    for (std::size_t i = 0; i < own.shafts_rps.size(); ++i) {
        // Of lever and telegraph; where blades turn, the shaft is asked for another speed.
        const core::ShaftState lever{.order_rps = own.shaftOrders_rps[i]};
        m_shafts->setShaft(i, own.shafts_rps[i], core::demandOf(units[i], lever).speed_rps);
    }
    m_wind->setRelative(r.relativeFrom_rad, r.relative_mps);
    m_wind->setTrue(r.windFrom_rad, r.wind_mps, r.heading_rad);
    m_depth->setDepth(r.underKeel_m, depthAlarm_m);
    m_clock->setTimes(localTime(m_world, now.time()), utcTime(m_world, now.time()));
}

}  // namespace sagara::ui::console
