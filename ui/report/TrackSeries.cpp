#include "ui/report/TrackSeries.h"

#include <cmath>

#include "core/base/Angle.h"

namespace sagara::report {
namespace {

/// 0 to 360; a gap where there is none.
double trueHeading_deg(const RunReport& report, const TrackPoint& point) {
    if (!std::isfinite(point.heading_rad)) return kGap;
    const double true_rad = point.heading_rad - report.frame.convergence_rad(point.position);
    return core::wrapTwoPi(true_rad) / core::kDegree_rad;
}

/// The same direction, on the turn nearest to the last one.
double headingNear(double heading_deg, double last_deg) {
    if (!std::isfinite(last_deg)) return heading_deg;
    return last_deg + std::remainder(heading_deg - last_deg, 360.0);
}

}  // namespace

PlotSeries limitSeries(const RunReport& report, const std::vector<double>& limits_mps, const QString& name,
                       const QPen& pen) {
    PlotSeries series{name, pen, {}};
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

PlotSeries unwrappedHeading(const RunReport& report, const QPen& pen) {
    PlotSeries series{{}, pen, {}};
    double last_deg = kGap;
    for (const TrackPoint& point : report.track) {
        const double now_deg = headingNear(trueHeading_deg(report, point), last_deg);
        if (std::isfinite(now_deg)) last_deg = now_deg;
        series.points.emplace_back(point.time_s, now_deg);
    }
    return series;
}

}  // namespace sagara::report
