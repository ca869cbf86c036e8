#include "ui/report/FreeSpot.h"

#include <algorithm>
#include <cmath>

#include "ui/chart/Corridor.h"
#include "ui/chart/Polyline.h"

namespace sagara::report {
namespace {

constexpr double kEdge_mm = 2.5;   ///< from the frame to a box in its corner
constexpr double kClear_mm = 3.0;  ///< from a box to what must not be hidden

/// Points on the page no farther than a few mm from each other along a line.
void addDense(std::vector<QPointF>& points, const QPolygonF& line) {
    constexpr double kStep_mm = 1.5;
    for (qsizetype i = 0; i < line.size(); ++i) {
        points.push_back(line[i]);
        if (i == 0) continue;
        const QPointF step = line[i] - line[i - 1];
        const int between = std::min(400, static_cast<int>(std::hypot(step.x(), step.y()) / kStep_mm));
        for (int k = 1; k <= between; ++k) points.push_back(line[i - 1] + step * k / (between + 1.0));
    }
}

}  // namespace

std::vector<QPointF> pointsToKeepFree(const RunReport& report, const ChartView& view) {
    std::vector<QPointF> points;
    std::vector<core::NorthEast> track;
    for (const TrackPoint& p : report.track) track.push_back(p.position);
    addDense(points, view.toPage(chart::simplified(track, view.toMetres(0.3))));
    for (const chart::CorridorPiece& piece :
         chart::corridorPieces(report.route, report.path, view.toMetres(2.0))) {
        for (const core::NorthEast corner : piece.corners) points.push_back(view.toPage(corner));
    }
    for (const core::Route::Waypoint& w : report.route.waypoints) points.push_back(view.toPage(w.position));
    for (const DeductionLine& d : report.deductions) points.push_back(view.toPage(d.place));
    for (const AnchorDrop& a : report.anchors) points.push_back(view.toPage(a.position));
    return points;
}

std::vector<QRectF> boxSpots(const QRectF& frame, QSizeF size) {
    const QRectF inner = frame.adjusted(kEdge_mm, kEdge_mm, -kEdge_mm, -kEdge_mm);
    const double right = inner.right() - size.width(), bottom = inner.bottom() - size.height();
    const double middleX = 0.5 * (inner.left() + right), middleY = 0.5 * (inner.top() + bottom);
    std::vector<QRectF> all;
    for (const QPointF at :
         {QPointF(right, bottom), QPointF(inner.left(), bottom), QPointF(inner.left(), inner.top()),
          QPointF(right, inner.top()), QPointF(inner.left(), middleY), QPointF(right, middleY),
          QPointF(middleX, bottom), QPointF(middleX, inner.top())}) {
        all.emplace_back(at, size);
    }
    return all;
}

std::size_t hiddenPoints(const QRectF& box, const std::vector<QPointF>& points) {
    const QRectF wide = box.adjusted(-kClear_mm, -kClear_mm, kClear_mm, kClear_mm);
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](QPointF p) { return wide.contains(p); }));
}

QRectF freeSpot(const QRectF& frame, QSizeF size, const std::vector<QPointF>& points,
                const std::vector<QRectF>& blocked) {
    QRectF best;
    std::size_t least = static_cast<std::size_t>(-1);
    for (const QRectF& spot : boxSpots(frame, size)) {
        const bool taken =
            std::any_of(blocked.begin(), blocked.end(), [&](const QRectF& b) { return b.intersects(spot); });
        const std::size_t count = hiddenPoints(spot, points) + (taken ? 1000000 : 0);
        if (count >= least) continue;
        least = count;
        best = spot;
    }
    return best;
}

}  // namespace sagara::report
