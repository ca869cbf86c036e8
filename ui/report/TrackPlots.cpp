#include "ui/report/TrackPlots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/report/Format.h"
#include "ui/report/SpeedLimits.h"
#include "ui/report/Style.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kLine_mm = 0.3;
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

template <typename ValueOf>
PlotSeries seriesOf(const RunReport& report, const QString& name, const QPen& pen, ValueOf&& valueOf) {
    PlotSeries series{name, pen, {}};
    for (const TrackPoint& point : report.track) series.points.emplace_back(point.time_s, valueOf(point));
    return series;
}

/// A constant across the plot.
PlotSeries levelLine(const RunReport& report, const QString& name, const QPen& pen, double value) {
    const double end_s = report.track.empty() ? report.duration_s : report.track.back().time_s;
    return {name, pen, {{0.0, value}, {end_s, value}}};
}

QPen limitPen() { return dashedPen(colour::kFailed, 0.3, 1.2, 0.9); }

std::vector<double> valuesOf(const std::vector<PlotSeries>& all) {
    std::vector<double> values;
    for (const PlotSeries& series : all) {
        for (const QPointF& p : series.points) values.push_back(p.y());
    }
    return values;
}

/// The point of a series that `better` prefers, nothing when it has no finite one.
template <typename Better>
const QPointF* extreme(const PlotSeries& series, Better&& better) {
    const QPointF* best = nullptr;
    for (const QPointF& p : series.points) {
        if (std::isfinite(p.y()) && (!best || better(p.y(), best->y()))) best = &p;
    }
    return best;
}

bool larger(double a, double b) { return a > b; }
bool smaller(double a, double b) { return a < b; }
bool fartherFromZero(double a, double b) { return std::abs(a) > std::abs(b); }

/// "most 9.8 at 12:20"
QString remark(const QString& word, const QPointF* p, int decimals) {
    if (!p) return {};
    return tr("%1 %2 at %3").arg(word, number(p->y(), decimals), clockTime(p->x()));
}

/// "most 26 to port at 21:49" of the value farthest from zero
QString sidedRemark(const PlotSeries& series, int decimals) {
    const QPointF* p = extreme(series, fartherFromZero);
    if (!p || number(p->y(), decimals) == number(0.0, decimals)) return {};
    const QString side = p->y() < 0.0 ? tr("to port") : tr("to starboard");
    return tr("most %1 %2 at %3").arg(number(std::abs(p->y()), decimals), side, clockTime(p->x()));
}

std::function<QString(double)> plainTicks(const Axis& axis) {
    const int decimals =
        axis.step < 0.995 ? (axis.step < 0.0995 ? 2 : 1) : (std::fmod(axis.step, 1.0) > 1e-9 ? 1 : 0);
    return [decimals](double value) { return number(value, decimals); };
}

Plot plotOf(const QString& title, std::vector<PlotSeries> series, const AxisRule& rule) {
    Plot plot{title, {}, std::move(series), {}, {}};
    plot.axis = axisFor(valuesOf(plot.series), rule);
    plot.tickText = plainTicks(plot.axis);
    return plot;
}

/// The limit as a staircase: it changes at once.
PlotSeries limitSeries(const RunReport& report, const std::vector<double>& limits_mps) {
    PlotSeries series{tr("limit"), limitPen(), {}};
    for (std::size_t i = 0; i < limits_mps.size(); ++i) {
        const double limit_kn = limits_mps[i] > 0.0 ? limits_mps[i] / core::kKnot_mps : kGap;
        const double time_s = report.track[i].time_s;
        if (i > 0 && std::isfinite(limit_kn) && limits_mps[i] != limits_mps[i - 1]) {
            series.points.emplace_back(time_s, series.points.back().y());
        }
        series.points.emplace_back(time_s, limit_kn);
    }
    return series;
}

Plot speedPlot(const RunReport& report) {
    std::vector<PlotSeries> series{
        seriesOf(report, tr("ship"), linePen(colour::kInk, kLine_mm),
                 [](const TrackPoint& p) { return p.speedOverGround_mps / core::kKnot_mps; })};
    const QString most = remark(tr("most"), extreme(series.front(), larger), 1);
    if (const std::vector<double> limits_mps = speedLimits_mps(report); !limits_mps.empty()) {
        series.push_back(limitSeries(report, limits_mps));
    } else {
        series.front().name.clear();
    }
    Plot plot = plotOf(tr("Speed over ground, kn"), std::move(series), {0.0, 4.0, false, 4, {}});
    plot.remark = most;
    return plot;
}

/// True heading without jumps at north: it goes on below 0 and above 360.
PlotSeries unwrappedHeading(const RunReport& report) {
    PlotSeries series{{}, linePen(colour::kInk, kLine_mm), {}};
    double last_deg = kGap;
    for (const TrackPoint& point : report.track) {
        const double true_rad = point.heading_rad - report.frame.convergence_rad(point.position);
        const double wrapped_deg = core::wrapTwoPi(true_rad) / core::kDegree_rad;
        const double from_deg = std::isfinite(last_deg) ? last_deg : wrapped_deg;
        const double now_deg = from_deg + std::remainder(wrapped_deg - from_deg, 360.0);
        if (std::isfinite(now_deg)) last_deg = now_deg;
        series.points.emplace_back(point.time_s, now_deg);
    }
    return series;
}

Plot headingPlot(const RunReport& report) {
    const std::vector<PlotSeries> series{unwrappedHeading(report)};
    const QPointF* low = extreme(series.front(), smaller);
    const QPointF* high = extreme(series.front(), larger);
    const double middle_deg = low ? 0.5 * (low->y() + high->y()) : 0.0;
    AxisRule rule{middle_deg - 10.0, middle_deg + 10.0, false, 4, {5, 10, 15, 30, 45, 90, 180, 360}};
    Plot plot = plotOf(tr("Heading, °T"), series, rule);
    plot.tickText = bearing;
    return plot;
}

Plot rudderPlot(const RunReport& report) {
    Plot plot = plotOf(tr("Rudder, °, to starboard positive"),
                       {seriesOf(report, {}, linePen(colour::kInk, kLine_mm),
                                 [](const TrackPoint& p) { return p.rudder_rad / core::kDegree_rad; })},
                       {0.0, 10.0, true, 4, {5, 10, 15, 20, 30}});
    plot.remark = sidedRemark(plot.series.front(), 0);
    return plot;
}

std::size_t shaftCount(const RunReport& report) {
    std::size_t count = 0;
    for (const TrackPoint& point : report.track) count = std::max(count, point.shafts_rps.size());
    return count;
}

QString shaftName(std::size_t shaft, std::size_t count) {
    if (count == 1) return {};
    if (count == 2) return shaft == 0 ? tr("port") : tr("starboard");
    return tr("shaft %1").arg(shaft + 1);
}

/// Told apart by dashes as much as by colour. The later ones are drawn over the earlier, which show through.
QPen shaftPen(std::size_t shaft, std::size_t count) {
    if (count == 1) return linePen(colour::kInk, kLine_mm);
    const bool portSide = 2 * shaft < count;
    const double dash_mm = 2.4 / static_cast<double>(1 + shaft / 2);
    return portSide && shaft == 0
               ? linePen(colour::kFailed, 0.45)
               : dashedPen(portSide ? colour::kFailed : colour::kPassed, 0.35, dash_mm, 1.0);
}

Plot shaftPlot(const RunReport& report) {
    std::vector<PlotSeries> series;
    const std::size_t count = shaftCount(report);
    for (std::size_t i = 0; i < count; ++i) {
        series.push_back(seriesOf(report, shaftName(i, count), shaftPen(i, count), [i](const TrackPoint& p) {
            return i < p.shafts_rps.size() ? p.shafts_rps[i] / core::kRpm_rps : kGap;
        }));
    }
    return plotOf(tr("Shaft speed, rpm, ahead positive"), std::move(series), {0.0, 50.0, false, 4, {}});
}

Plot rollPlot(const RunReport& report) {
    Plot plot = plotOf(tr("Roll, °, starboard down positive"),
                       {seriesOf(report, {}, linePen(colour::kInk, 0.25),
                                 [](const TrackPoint& p) { return p.roll_rad / core::kDegree_rad; })},
                       {0.0, 2.0, true, 4, {}});
    plot.remark = sidedRemark(plot.series.front(), 1);
    return plot;
}

Plot underKeelPlot(const RunReport& report) {
    const bool limited = report.underKeelLimit_m > 0.0;
    std::vector<PlotSeries> series{seriesOf(report, limited ? tr("ship") : QString(),
                                            linePen(colour::kInk, kLine_mm),
                                            [](const TrackPoint& p) { return p.underKeel_m; })};
    const QString least = remark(tr("least"), extreme(series.front(), smaller), 1);
    if (limited) series.push_back(levelLine(report, tr("limit"), limitPen(), report.underKeelLimit_m));
    Plot plot = plotOf(tr("Under-keel clearance, m"), std::move(series), {0.0, 2.0, false, 4, {}});
    plot.remark = least;
    return plot;
}

}  // namespace

std::vector<Plot> trackPlots(const RunReport& report) {
    return {speedPlot(report), headingPlot(report), rudderPlot(report),
            shaftPlot(report), rollPlot(report),    underKeelPlot(report)};
}

}  // namespace sagara::report
