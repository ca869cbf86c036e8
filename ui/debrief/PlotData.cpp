#include "ui/debrief/PlotData.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/assess/Mission.h"
#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"

namespace sagara::ui {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::Plots", text); }
double degrees(double rad) { return rad / core::kDegree_rad; }
double knots(double mps) { return mps / core::kKnot_mps; }

/// Adds the values of one moment to all curves.
class Gather {
public:
    Gather(const core::World& world, std::size_t count, bool orders) : m_world(world), m_orders(orders) {
        for (int kind = 0; kind < kPlotKinds; ++kind)
            m_data.plots.push_back({static_cast<PlotKind>(kind), {}});
        m_data.time_s.reserve(count);
        using Style = PlotCurve::Style;
        add(PlotKind::SpeedOverGround, tr("ship"), Style::Plain);
        add(PlotKind::SpeedOverGround, tr("limit"), Style::Limit);
        add(PlotKind::Heading, {}, Style::Plain);
        add(PlotKind::RateOfTurn, {}, Style::Plain);
        add(PlotKind::Rudder, tr("angle"), Style::Plain);
        if (orders) add(PlotKind::Rudder, tr("order"), Style::Ordered);
        const auto& units = world.ships[0]->vessel.propulsion.units;
        for (const auto& unit : units) add(PlotKind::Shafts, QString::fromStdString(unit.id), Style::Plain);
        for (const auto& unit : units)
            if (orders)
                add(PlotKind::Shafts, tr("%1 order").arg(QString::fromStdString(unit.id)), Style::Ordered);
        add(PlotKind::CrossTrack, {}, Style::Plain);
        add(PlotKind::UnderKeel, tr("ship"), Style::Plain);
        add(PlotKind::UnderKeel, tr("limit"), Style::Limit);
        add(PlotKind::Roll, {}, Style::Plain);
        add(PlotKind::Pitch, {}, Style::Plain);
        add(PlotKind::ClearOfShips, {}, Style::Plain);
    }

    void take(const core::TrackSample& sample, const ReplayOrders::Sample* order) {
        const core::ShipSample& s = sample.ships[0];
        const core::Observation& o = s.observation;
        const bool routed = m_world.route.waypoints.size() >= 2;
        if (routed) core::follow(m_world.path, s.motion.position(), m_progress);
        const core::Limits limits = core::limitsAt(m_world.mission, o, m_progress);
        const double convergence_rad = m_world.area.frame.convergence_rad(s.motion.position());
        m_data.time_s.push_back(core::timeOfTick(sample.tick).seconds());
        put(PlotKind::SpeedOverGround,
            {knots(core::length(o.overGround_mps)),
             limits.speedOverGround_mps > 0.0 ? knots(limits.speedOverGround_mps) : kGap});
        put(PlotKind::Heading, {degrees(s.motion.heading_rad - convergence_rad)});
        put(PlotKind::RateOfTurn, {60.0 * degrees(s.motion.yawRate_radps)});
        std::vector<double> rudder{degrees(s.rudder_rad)}, shafts;
        const std::size_t count = m_world.ships[0]->shaftCount();
        for (std::size_t i = 0; i < count; ++i) shafts.push_back(s.shafts_rps[i] / core::kRpm_rps);
        if (m_orders) {
            rudder.push_back(order != nullptr ? degrees(order->rudder_rad) : kGap);
            for (std::size_t i = 0; i < count; ++i)
                shafts.push_back(order != nullptr ? order->shafts_rps[i] / core::kRpm_rps : kGap);
        }
        put(PlotKind::Rudder, rudder);
        put(PlotKind::Shafts, shafts);
        put(PlotKind::CrossTrack, {routed ? m_progress.offTrack_m : kGap});
        put(PlotKind::UnderKeel, {o.underKeel_m, limits.underKeel_m > 0.0 ? limits.underKeel_m : kGap});
        put(PlotKind::Roll, {degrees(s.motion.roll_rad)});
        put(PlotKind::Pitch, {degrees(s.motion.pitch_rad)});
        put(PlotKind::ClearOfShips, {o.clearOfShips_m < core::kShipsLimit_m ? o.clearOfShips_m : kGap});
    }

    PlotData data() && { return std::move(m_data); }

private:
    void add(PlotKind kind, const QString& name, PlotCurve::Style style) {
        m_data.plots[static_cast<std::size_t>(kind)].curves.push_back({name, style, {}});
    }
    void put(PlotKind kind, const std::vector<double>& values) {
        auto& curves = m_data.plots[static_cast<std::size_t>(kind)].curves;
        for (std::size_t i = 0; i < curves.size(); ++i)
            curves[i].values.push_back(static_cast<float>(values[i]));
    }

    const core::World& m_world;
    bool m_orders;
    core::RouteProgress m_progress;
    PlotData m_data;
};

struct Rule {
    double low, high;  ///< shown at least
    double least;      ///< step
    bool even;         ///< as far below zero as above
};

Rule ruleOf(PlotKind kind) {
    switch (kind) {
        case PlotKind::SpeedOverGround:
            return {0.0, 5.0, 1.0, false};
        case PlotKind::Heading:
            return {kGap, kGap, 5.0, false};
        case PlotKind::RateOfTurn:
            return {-10.0, 10.0, 5.0, true};
        case PlotKind::Rudder:
            return {-10.0, 10.0, 5.0, true};
        case PlotKind::Shafts:
            return {0.0, 100.0, 50.0, false};
        case PlotKind::CrossTrack:
            return {-20.0, 20.0, 10.0, true};
        case PlotKind::UnderKeel:
            return {0.0, 5.0, 1.0, false};
        case PlotKind::Roll:
        case PlotKind::Pitch:
            return {-1.0, 1.0, 0.5, true};
        case PlotKind::ClearOfShips:
            return {0.0, 500.0, 100.0, false};
    }
    return {0.0, 1.0, 0.1, false};
}

}  // namespace

std::size_t PlotData::at(double t) const {
    const auto after = std::upper_bound(time_s.begin(), time_s.end(), t + 1e-9);
    return after == time_s.begin() ? 0 : static_cast<std::size_t>(after - time_s.begin()) - 1;
}

PlotData plotData(const core::World& world, const std::vector<core::TrackSample>& track,
                  const ReplayOrders* orders) {
    PlotData none;
    for (int kind = 0; kind < kPlotKinds; ++kind) none.plots.push_back({static_cast<PlotKind>(kind), {}});
    if (world.ships.empty()) return none;
    Gather gather(world, track.size(), orders != nullptr);
    for (std::size_t i = 0; i < track.size(); ++i) {
        const bool known = orders != nullptr && i < orders->samples.size();
        if (!track[i].ships.empty()) gather.take(track[i], known ? &orders->samples[i] : nullptr);
    }
    return std::move(gather).data();
}

QString plotTitle(PlotKind kind) {
    switch (kind) {
        case PlotKind::SpeedOverGround:
            return tr("Speed over ground, kn");
        case PlotKind::Heading:
            return tr("Heading, °T");
        case PlotKind::RateOfTurn:
            return tr("Rate of turn, °/min, starboard +");
        case PlotKind::Rudder:
            return tr("Rudder, °, starboard +");
        case PlotKind::Shafts:
            return tr("Shaft speed, rpm, ahead +");
        case PlotKind::CrossTrack:
            return tr("Off the track, m, starboard +");
        case PlotKind::UnderKeel:
            return tr("Under the keel, m");
        case PlotKind::Roll:
            return tr("Roll, °, starboard down +");
        case PlotKind::Pitch:
            return tr("Pitch, °, bow up +");
        case PlotKind::ClearOfShips:
            return tr("Clear of other ships, m");
    }
    return {};
}

int plotDecimals(PlotKind kind) {
    switch (kind) {
        case PlotKind::SpeedOverGround:
        case PlotKind::Rudder:
        case PlotKind::UnderKeel:
        case PlotKind::Roll:
        case PlotKind::Pitch:
            return 1;
        default:
            return 0;
    }
}

QString plotFigure(PlotKind kind, double value, int decimals) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    return kind == PlotKind::Heading ? chart::bearing(value) : chart::number(value, decimals);
}

PlotAxis plotAxis(PlotKind kind, const std::vector<const Plot*>& plots, int most) {
    const Rule rule = ruleOf(kind);
    double low = rule.low, high = rule.high;
    for (const Plot* plot : plots) {
        for (const PlotCurve& curve : plot->curves) {
            for (const float value : curve.values) {
                if (!std::isfinite(value)) continue;
                low = std::isfinite(low) ? std::min<double>(low, value) : static_cast<double>(value);
                high = std::isfinite(high) ? std::max<double>(high, value) : static_cast<double>(value);
            }
        }
    }
    if (!std::isfinite(low)) low = 0.0, high = 90.0;
    if (rule.even) high = std::max(std::abs(low), std::abs(high)), low = -high;
    PlotAxis axis;
    constexpr std::array kSteps{1.0, 2.0, 2.5, 5.0};
    constexpr std::array kTurns{5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0, 720.0};
    const auto fits = [&](double step) {
        return step >= rule.least && std::ceil(high / step) - std::floor(low / step) <= std::max(1, most);
    };
    axis.step = 0.0;
    if (kind == PlotKind::Heading) {
        for (const double step : kTurns)
            if (axis.step == 0.0 && fits(step)) axis.step = step;
    } else {
        for (double decade = 0.1; decade < 1e6 && axis.step == 0.0; decade *= 10.0)
            for (const double step : kSteps)
                if (axis.step == 0.0 && fits(step * decade)) axis.step = step * decade;
    }
    if (axis.step == 0.0) axis.step = high - low;
    axis.low = axis.step * std::floor(low / axis.step);
    axis.high = axis.step * std::ceil(high / axis.step);
    if (axis.high <= axis.low) axis.high = axis.low + axis.step;
    axis.decimals = std::abs(axis.step - std::round(axis.step)) < 1e-9 ? 0 : 1;
    return axis;
}

}  // namespace sagara::ui
