#include "ui/widgets/PreparedChart.h"

#include <algorithm>
#include <array>

namespace sagara::ui {
namespace {

using core::NorthEast;
using Shade = PreparedChart::DepthArea::Shade;

constexpr std::array<double, 4> kContours_m{2.0, 5.0, 10.0, 20.0};

std::vector<ChartLine> chartLines(std::vector<std::vector<NorthEast>> lines) {
    std::vector<ChartLine> made;
    for (auto& line : lines) {
        if (line.size() > 1) made.emplace_back(std::move(line));
    }
    return made;
}

struct Step {
    double from_m;
    Shade shade;
};

/// Where the shades change: at the datum, the deepest contour short of the safety depth, the safety depth,
/// and the first contour at least twice as deep.
std::vector<Step> shadesFor(double safety_m) {
    std::vector<Step> steps{{0.0, Shade::Shallow}};
    for (const double depth_m : kContours_m) {
        if (depth_m < safety_m) steps.push_back({depth_m, Shade::Unsafe});
    }
    if (steps.size() > 2) steps.erase(steps.begin() + 1, steps.end() - 1);
    steps.push_back({safety_m, Shade::Safe});
    const auto deep = std::find_if(kContours_m.begin(), kContours_m.end(),
                                   [&](double depth_m) { return depth_m >= 2.0 * safety_m; });
    if (deep != kContours_m.end()) steps.push_back({*deep, Shade::Deep});
    return steps;
}

PreparedChart::GridAreas areasOf(const core::Grid& grid, double safety_m) {
    const std::size_t top = grid.rows() - 1, right = grid.columns() - 1;
    PreparedChart::GridAreas made;
    made.border = {grid.node(0, 0), grid.node(top, 0), grid.node(top, right), grid.node(0, right)};
    for (const Step& step : shadesFor(safety_m)) {
        made.depths.push_back({step.from_m, step.shade, chartLines(chart::deeperThan(grid, step.from_m))});
    }
    return made;
}

void addContours(PreparedChart& chart, double safety_m) {
    std::vector<double> depths_m;
    std::copy_if(kContours_m.begin(), kContours_m.end(), std::back_inserter(depths_m),
                 [&](double depth_m) { return depth_m != safety_m; });
    depths_m.push_back(safety_m);
    for (chart::Contour& contour : chart::contoursOf(*chart.area, depths_m)) {
        chart.contours.push_back(
            {contour.depth_m, contour.depth_m == safety_m, chartLines(std::move(contour.lines))});
    }
}

void addShores(PreparedChart& chart) {
    for (const core::ShoreLine& line : chart.area->shore.lines()) {
        const bool stone = line.kind == core::ShoreKind::Quay || line.kind == core::ShoreKind::Jetty ||
                           line.kind == core::ShoreKind::Breakwater;
        if (line.points.size() > 1) (stone ? chart.stone : chart.coast).emplace_back(line.points);
    }
}

void findExtent(PreparedChart& chart) {
    for (const auto& grid : chart.grids) {
        for (const NorthEast corner : grid.border) chart.extent.include(corner);
    }
    for (const core::Mark& mark : chart.area->marks) chart.extent.include(mark.position);
    if (!chart.grids.empty()) return;
    for (const ChartLine& ring : chart.land) {
        for (const NorthEast p : ring.points) chart.extent.include(p);
    }
}

}  // namespace

ChartLine::ChartLine(std::vector<NorthEast> line) : points(std::move(line)) {
    for (const NorthEast p : points) box.include(p);
}

bool PreparedChart::hasDepth(NorthEast p) const {
    return area && std::any_of(area->depths.begin(), area->depths.end(),
                               [&](const core::Grid& grid) { return grid.covers(p); });
}

std::shared_ptr<const PreparedChart> prepareChart(std::shared_ptr<const core::Area> area, double safety_m) {
    auto made = std::make_shared<PreparedChart>();
    made->area = std::move(area);
    made->safety_m = safety_m;
    if (!made->area) return made;
    const core::Area& from = *made->area;
    for (auto grid = from.depths.rbegin(); grid != from.depths.rend(); ++grid) {
        made->grids.push_back(areasOf(*grid, safety_m));
    }
    if (!from.depths.empty()) addContours(*made, safety_m);
    made->context = chartLines(from.context);
    made->land = chartLines(from.land);
    addShores(*made);
    for (const core::Mark& mark : from.marks)
        made->marks.push_back(chart::chartMarkOf(mark, from.ialaRegion));
    findExtent(*made);
    return made;
}

}  // namespace sagara::ui
