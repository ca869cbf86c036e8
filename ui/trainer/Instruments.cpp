#include "ui/trainer/Instruments.h"

#include <QGridLayout>
#include <QLabel>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/widgets/Measure.h"

namespace sagara::ui {
namespace {

constexpr double kLeastTurn_radps = 0.05 * core::kDegree_rad;
constexpr double kLeastWay_mps = 0.1;

double degrees(double rad) { return rad / core::kDegree_rad; }
double knots(double mps) { return mps / core::kKnot_mps; }
QString fixed(double value, int decimals) { return QString::number(value, 'f', decimals); }
/// "port 3.2", "starboard 3.2", "0.0".
QString sided(double value, int decimals, const QString& negative, const QString& positive) {
    const QString number = fixed(std::abs(value), decimals);
    if (number.toDouble() == 0.0) return number;
    return (value < 0.0 ? negative : positive) + QLatin1Char(' ') + number;
}

}  // namespace

std::optional<double> pivotAhead_m(const core::ShipMotion& m) {
    if (std::abs(m.yawRate_radps) < kLeastTurn_radps) return std::nullopt;
    return -m.sway_mps / m.yawRate_radps;
}

Instruments::Instruments(const core::World& world, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_world(world), m_ship(ship) {
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(8, 8, 8, 8);
    grid->setVerticalSpacing(3);
    grid->setHorizontalSpacing(4);
    grid->setColumnStretch(1, 1);
    m_heading = row(tr("Heading"), tr("°T"), tr("True heading"));
    m_course = row(tr("Course over ground"), tr("°T"), tr("Where she goes over the ground"));
    m_speedOverGround = row(tr("Speed over ground"), tr("kn"), {});
    m_speedThroughWater = row(tr("Speed through water"), tr("kn"), tr("Along the keel, ahead positive"));
    m_rateOfTurn = row(tr("Rate of turn"), tr("°/min"), {});
    m_drift =
        row(tr("Drift angle"), tr("°"), tr("From the way she points to the way she moves through the water"));
    m_pivot = row(tr("Pivot point"), tr("m"), tr("Point about which she turns, from midship"));
    m_rudder = row(tr("Rudder (ordered)"), tr("°"), {});
    const auto& units = world.ships[ship]->vessel.propulsion.units;
    for (const core::PropulsionUnit& unit : units) {
        const QString name = QString::fromStdString(unit.id);
        m_shafts.push_back(row(tr("Shaft %1 (ordered)").arg(name), tr("rpm"), {}));
        m_bladePitches.push_back(unit.pitch
                                     ? row(tr("Blades %1 (ordered)").arg(name), tr("%"),
                                           tr("Pitch of the blades over the design pitch, ahead positive"))
                                     : nullptr);
        m_drives.push_back(unit.azimuth ? row(tr("Drive %1 (ordered)").arg(name), tr("°"),
                                              tr("Where the drive pushes her, clockwise from ahead; the "
                                                 "order is without the wheel"))
                                        : nullptr);
    }
    m_depth = row(tr("Under the keel"), tr("m"), tr("Water under the keel"));
    m_wind = row(tr("True wind"), tr("kn"), tr("From where, with its gusts"));
    m_roll = row(tr("Roll"), tr("°"), {});
    m_pitch = row(tr("Pitch"), tr("°"), {});
    grid->setRowStretch(grid->rowCount(), 1);
}

QLabel* Instruments::row(const QString& name, const QString& unit, const QString& tip) {
    auto* const grid = static_cast<QGridLayout*>(layout());
    const int at = grid->rowCount();
    auto* const value = new QLabel(this);
    QFont font = value->font();
    font.setBold(true);
    value->setFont(font);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* const label = new QLabel(name, this);
    label->setToolTip(tip.isEmpty() ? tr("%1 in %2").arg(name, unit) : tip);
    grid->addWidget(label, at, 0);
    grid->addWidget(value, at, 1);
    grid->addWidget(new QLabel(unit, this), at, 2);
    return value;
}

void Instruments::show(const core::Snapshot& now) {
    if (m_ship >= now.ships.size()) return;
    const core::OwnShipView& s = now.ships[m_ship];
    const core::ShipMotion& m = s.motion;
    const QString port = tr("port"), starboard = tr("starboard");
    const auto trueBearing = [&](double grid_rad) {
        return chart::bearing(degrees(trueDirection_rad(m_world.area.frame, m.position(), grid_rad)));
    };
    const double overGround_mps = std::hypot(s.overGround_mps.north_m, s.overGround_mps.east_m);
    const double throughWater_mps = std::hypot(m.surge_mps, m.sway_mps);
    m_heading->setText(trueBearing(m.heading_rad));
    m_course->setText(overGround_mps > kLeastWay_mps
                          ? trueBearing(std::atan2(s.overGround_mps.east_m, s.overGround_mps.north_m))
                          : tr("none"));
    m_speedOverGround->setText(fixed(knots(overGround_mps), 1));
    m_speedThroughWater->setText(fixed(knots(m.surge_mps), 1));
    m_rateOfTurn->setText(sided(60.0 * degrees(m.yawRate_radps), 0, port, starboard));
    m_drift->setText(throughWater_mps > kLeastWay_mps
                         ? sided(degrees(std::atan2(m.sway_mps, m.surge_mps)), 1, port, starboard)
                         : tr("none"));
    const auto pivot_m = pivotAhead_m(m);
    m_pivot->setText(pivot_m && std::abs(*pivot_m) < 1000.0 ? sided(*pivot_m, 0, tr("abaft"), tr("ahead"))
                                                            : tr("none"));
    m_rudder->setText(tr("%1 (%2)").arg(sided(degrees(s.rudder_rad), 1, tr("P"), tr("S")),
                                        sided(degrees(s.rudderOrder_rad), 1, tr("P"), tr("S"))));
    for (std::size_t i = 0; i < std::min(m_shafts.size(), s.shafts_rps.size()); ++i)
        m_shafts[i]->setText(tr("%1 (%2)").arg(fixed(s.shafts_rps[i] / core::kRpm_rps, 0),
                                               fixed(s.shaftOrders_rps[i] / core::kRpm_rps, 0)));
    const auto fromAhead = [](double rad) { return chart::bearing(degrees(core::wrapTwoPi(rad))); };
    for (std::size_t i = 0; i < std::min(m_shafts.size(), s.drives.size()); ++i) {
        const core::DriveView& drive = s.drives[i];
        if (m_bladePitches[i] != nullptr)
            m_bladePitches[i]->setText(
                tr("%1 (%2)").arg(fixed(100.0 * drive.pitch, 0), fixed(100.0 * drive.pitchOrder, 0)));
        if (m_drives[i] != nullptr)
            m_drives[i]->setText(
                tr("%1 (%2)").arg(fromAhead(drive.azimuth_rad), fromAhead(drive.azimuthOrder_rad)));
    }
    m_depth->setText(s.aground ? tr("aground") : fixed(s.underKeel_m, 1));
    m_wind->setText(
        tr("%1°T %2").arg(trueBearing(now.wind.windFrom_rad), fixed(knots(now.wind.speed_mps), 0)));
    m_roll->setText(sided(degrees(m.roll_rad), 1, port, starboard));
    m_pitch->setText(sided(degrees(m.pitch_rad), 1, tr("down"), tr("up")));
}

}  // namespace sagara::ui
