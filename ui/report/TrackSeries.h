#pragma once

#include <QPen>
#include <QString>
#include <limits>
#include <vector>

#include "ui/report/ReportData.h"
#include "ui/report/TimePlot.h"

namespace sagara::report {

/// A value that breaks a line.
inline constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

/// One value of every track point.
template <typename ValueOf>
PlotSeries seriesOf(const RunReport& report, const QString& name, const QPen& pen, ValueOf&& valueOf) {
    PlotSeries series{name, pen, {}};
    for (const TrackPoint& point : report.track) series.points.emplace_back(point.time_s, valueOf(point));
    return series;
}

/// Speed limits in kn as a staircase: a limit changes at once.
PlotSeries limitSeries(const RunReport& report, const std::vector<double>& limits_mps, const QString& name,
                       const QPen& pen);

/// True heading in degrees without jumps at north: it goes on below 0 and above 360.
PlotSeries unwrappedHeading(const RunReport& report, const QPen& pen);

}  // namespace sagara::report
