#pragma once

#include <QPainter>
#include <QPointF>
#include <QString>
#include <functional>
#include <vector>

#include "ui/report/ReportData.h"

namespace sagara::report {

/// A sign, drawn about a point within 9 mm, and its meaning.
struct LegendEntry {
    std::function<void(QPainter&, QPointF)> draw;
    QString meaning;
};

/// Of what the chart of this run shows. `interval_s`: between two outlines of the ship.
std::vector<LegendEntry> legendEntries(const RunReport& report, double interval_s);

}  // namespace sagara::report
