#include <cmath>

#include "ui/chart/Polyline.h"
#include "ui/report/Chart.h"
#include "ui/report/ChartSigns.h"

namespace sagara::report {
namespace {

const TextStyle kOtherStyle{6.0, colour::kOtherText};
const TextStyle kHostileStyle{6.0, colour::kHostile, true};

/// The end of a track: where its ship was last, or the last place that this chart shows.
const core::NorthEast* lastShown(const Chart& chart, const OtherTrack& other) {
    for (std::size_t i = other.points.size(); i-- > 0;) {
        if (chart.details(other.points[i])) return &other.points[i];
    }
    return nullptr;
}

/// A dot for a ship that lay still, a small triangle along the way of one that moved.
void drawEnd(Chart& chart, const OtherTrack& other) {
    const QPointF end = chart.view.toPage(other.points.back());
    std::size_t i = other.points.size() - 1;
    while (i > 0 && core::distance(other.points[i], other.points.back()) < 5.0) --i;
    const core::NorthEast way = other.points.back() - other.points[i];
    if (core::length(way) < 5.0) {
        chart.painter.drawEllipse(end, 0.55, 0.55);
        return;
    }
    const double ahead_rad = core::bearing_rad({}, way);
    QPolygonF tip;
    for (const double turn_rad : {0.0, 2.6, -2.6}) {
        const core::NorthEast corner = 1.1 * core::unitVector(ahead_rad + turn_rad);
        tip << end + QPointF(corner.east_m, -corner.north_m);
    }
    chart.painter.drawPolygon(tip);
}

}  // namespace

void drawOtherTracks(Chart& chart) {
    for (const OtherTrack& other : chart.report.others) {
        if (other.points.empty()) continue;
        const QColor colour = other.hostile ? colour::kHostile : colour::kOther;
        const auto line = chart::simplified(other.points, chart.view.toMetres(0.05));
        chart.painter.setPen(otherTrackPen(other.hostile));
        chart.painter.setBrush(Qt::NoBrush);
        chart.painter.drawPolyline(chart.view.toPage(line));
        chart.painter.setPen(linePen(colour, 0.1));
        chart.painter.setBrush(colour);
        drawEnd(chart, other);
    }
}

void labelOtherTracks(Chart& chart) {
    for (const OtherTrack& other : chart.report.others) {
        const core::NorthEast* at = lastShown(chart, other);
        if (!at) continue;
        labelNear(chart, chart.view.toPage(*at), 1.2, 10.0, fromStd(other.name),
                  other.hostile ? kHostileStyle : kOtherStyle);
    }
}

}  // namespace sagara::report
