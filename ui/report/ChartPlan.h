#pragma once

#include <QRectF>
#include <optional>

#include "ui/report/ChartView.h"
#include "ui/report/ReportData.h"

namespace sagara::report {

/// How the chart page is divided: the chart of the whole run and, where the ship is too small on it, an inset
/// of the first part of the track.
struct ChartPlan {
    ChartView main;
    std::optional<ChartView> inset;
    QRectF insetBox;                    ///< with its title and border texts
    std::optional<QRectF> insetOnMain;  ///< what the inset shows, as it lies on the main chart
};

/// Chooses scales, and a place for the inset where it hides nothing of the run.
ChartPlan planCharts(const RunReport& report, const QRectF& area);

}  // namespace sagara::report
