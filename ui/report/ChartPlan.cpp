#include "ui/report/ChartPlan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/report/FreeSpot.h"

namespace sagara::report {
namespace {

using core::NorthEast;

constexpr double kMargin_mm = 11.0;  ///< around what must be shown, for labels
constexpr double kLeastDenominator = 2500.0;
constexpr double kEmptyDenominator = 25000.0;  ///< when there is nothing to show
constexpr double kInsetTitle_mm = 5.0;
constexpr double kInsetBorder_mm = 4.5;  ///< for the texts of latitude and longitude
const QSizeF kInsetSize_mm(82.0, 80.0);
constexpr double kShipTooSmall_mm = 6.5;  ///< a ship shorter than this on the main chart asks for an inset
constexpr double kInsetZoom = 2.8;
constexpr double kInsetMargin_mm = 7.0;

Extent whatMustBeShown(const RunReport& report) {
    Extent extent;
    for (const TrackPoint& p : report.track) extent.include(p.position);
    for (const core::Route::Waypoint& w : report.route.waypoints) extent.include(w.position);
    for (const DeductionLine& d : report.deductions) extent.include(d.place);
    for (const AnchorDrop& a : report.anchors) extent.include(a.position);
    return extent;
}

Extent anythingAtAll(const RunReport& report) {
    Extent extent;
    for (const ChartMark& mark : report.marks) extent.include(mark.position);
    if (extent.empty) extent.include({0.0, 0.0});
    return extent;
}

ChartView fitted(const RunReport& report, const QRectF& frame) {
    const Extent extent = whatMustBeShown(report);
    if (extent.empty) return {frame, anythingAtAll(report).centre(), kEmptyDenominator};
    const double wide = 1000.0 * extent.width_m() / (frame.width() - 2.0 * kMargin_mm);
    const double high = 1000.0 * extent.height_m() / (frame.height() - 2.0 * kMargin_mm);
    return {frame, extent.centre(), denominatorAtLeast(std::max({wide, high, kLeastDenominator}))};
}

bool wantsInset(const RunReport& report, const ChartView& main) {
    const double ship_m = report.shipLength_m > 0.0 ? report.shipLength_m : 50.0;
    return report.track.size() >= 2 && main.toMm(ship_m) < kShipTooSmall_mm;
}

QRectF innerFrame(const QRectF& box) {
    return box.adjusted(kInsetBorder_mm, kInsetTitle_mm, -1.5, -kInsetBorder_mm);
}

/// The first part of the track, as far as it fits, to a scale some times that of the main chart.
ChartView insetView(const RunReport& report, const QRectF& box, double mainDenominator) {
    const QRectF frame = innerFrame(box);
    const double denominator = denominatorAtMost(mainDenominator / kInsetZoom);
    ChartView view(frame, report.track.front().position, denominator);
    const double width_m = view.toMetres(frame.width() - 2.0 * kInsetMargin_mm);
    const double height_m = view.toMetres(frame.height() - 2.0 * kInsetMargin_mm);
    Extent shown;
    for (const TrackPoint& p : report.track) {
        Extent grown = shown;
        grown.include(p.position);
        if (grown.width_m() > width_m || grown.height_m() > height_m) break;
        shown = grown;
    }
    return shown.empty ? view : ChartView(frame, shown.centre(), denominator);
}

/// The main chart moved within the room its scale leaves, least first.
std::vector<ChartView> movedViews(const RunReport& report, const ChartView& view) {
    const Extent extent = whatMustBeShown(report);
    const double spareEast_m = view.toMetres(view.frame().width() - 2.0 * kMargin_mm) - extent.width_m();
    const double spareNorth_m = view.toMetres(view.frame().height() - 2.0 * kMargin_mm) - extent.height_m();
    std::vector<ChartView> moved;
    for (const auto& [north, east] : std::array<std::array<double, 2>, 9>{{{0, 0},
                                                                           {0, -0.25},
                                                                           {0, 0.25},
                                                                           {-0.25, 0},
                                                                           {0.25, 0},
                                                                           {0, -0.5},
                                                                           {0, 0.5},
                                                                           {-0.5, 0},
                                                                           {0.5, 0}}}) {
        const NorthEast shift{north * std::max(0.0, spareNorth_m), east * std::max(0.0, spareEast_m)};
        moved.emplace_back(view.frame(), view.centre() + shift, view.denominator());
    }
    return moved;
}

void setInset(ChartPlan& plan, const RunReport& report, const QRectF& box) {
    plan.insetBox = box;
    plan.inset = insetView(report, box, plan.main.denominator());
    const Extent shown = plan.inset->extent();
    plan.insetOnMain =
        QRectF(plan.main.toPage(shown.southWest), plan.main.toPage(shown.northEast)).normalized();
}

/// An inset in a corner of the main chart where it hides nothing, if there is such a corner.
std::optional<ChartPlan> withInsetInside(const RunReport& report, const ChartView& view) {
    for (const ChartView& moved : movedViews(report, view)) {
        const std::vector<QPointF> points = pointsToKeepFree(report, moved);
        for (const QRectF& box : boxSpots(moved.frame(), kInsetSize_mm)) {
            if (hiddenPoints(box, points) > 0) continue;
            ChartPlan plan{moved, {}, {}, {}};
            setInset(plan, report, box);
            if (!plan.insetOnMain->intersects(box)) return plan;
        }
    }
    return {};
}

ChartPlan withInsetBelow(const RunReport& report, const QRectF& area) {
    const double below_mm = kInsetSize_mm.height() + 6.0;  // the main chart's texts of longitude lie between
    ChartPlan plan{fitted(report, area.adjusted(0.0, 0.0, 0.0, -below_mm)), {}, {}, {}};
    const QRectF box(area.left() - kInsetBorder_mm, area.bottom() - kInsetSize_mm.height(),
                     area.width() + kInsetBorder_mm, kInsetSize_mm.height() + kInsetBorder_mm);
    setInset(plan, report, box);
    return plan;
}

}  // namespace

ChartPlan planCharts(const RunReport& report, const QRectF& area) {
    const ChartView view = fitted(report, area);
    if (!wantsInset(report, view)) return {view, {}, {}, {}};
    const std::optional<ChartPlan> inside = withInsetInside(report, view);
    return inside ? *inside : withInsetBelow(report, area);
}

}  // namespace sagara::report
