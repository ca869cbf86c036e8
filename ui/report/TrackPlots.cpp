#include "ui/report/TrackPlots.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/report/Format.h"
#include "ui/report/Remarks.h"
#include "ui/report/SpeedLimits.h"
#include "ui/report/Style.h"
#include "ui/report/Text.h"
#include "ui/report/TrackSeries.h"

namespace sagara::report {
namespace {

constexpr double kLine_mm = 0.3;

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

Plot speedPlot(const RunReport& report) {
    std::vector<PlotSeries> series{
        seriesOf(report, tr("ship"), linePen(colour::kInk, kLine_mm),
                 [](const TrackPoint& p) { return p.speedOverGround_mps / core::kKnot_mps; })};
    const QString most = remark(tr("most"), highest(series.front()), 1);
    double headroom_kn = 4.0;
    if (const std::vector<double> limits_mps = speedLimits_mps(report); !limits_mps.empty()) {
        headroom_kn = 1.1 * *std::max_element(limits_mps.begin(), limits_mps.end()) / core::kKnot_mps;
        series.push_back(limitSeries(report, limits_mps, tr("limit"), limitPen()));
    } else {
        series.front().name.clear();
    }
    Plot plot = plotOf(tr("Speed over ground, kn"), std::move(series), {0.0, headroom_kn, false, 4, {}});
    plot.remark = most;
    return plot;
}

Plot headingPlot(const RunReport& report) {
    const std::vector<PlotSeries> series{unwrappedHeading(report, linePen(colour::kInk, kLine_mm))};
    const QPointF* low = lowest(series.front());
    const QPointF* high = highest(series.front());
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
                       {seriesOf(report, {}, linePen(colour::kInk, 0.2),
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
    const QString least = remark(tr("least"), lowest(series.front()), 1);
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
