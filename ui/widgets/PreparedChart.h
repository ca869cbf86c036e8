#pragma once

#include <memory>
#include <vector>

#include "core/world/Area.h"
#include "ui/chart/Contours.h"
#include "ui/chart/Extent.h"
#include "ui/chart/Marks.h"

namespace sagara::ui {

/// A line or ring with the box it lies in.
struct ChartLine {
    explicit ChartLine(std::vector<core::NorthEast> line);
    std::vector<core::NorthEast> points;
    chart::Extent box;
};

/// An area worked out for drawing. Takes a tenth of a second or two to make, in any thread; immutable.
struct PreparedChart {
    std::shared_ptr<const core::Area> area;
    double safety_m = 0.0;

    /// The water of one grid that is at least so deep.
    struct DepthArea {
        enum class Shade { Shallow, Unsafe, Safe, Deep };
        double from_m = 0.0;
        Shade shade = Shade::Shallow;
        std::vector<ChartLine> rings;  ///< filled by the odd-even rule
    };
    struct GridAreas {
        std::vector<core::NorthEast> border;
        std::vector<DepthArea> depths;  ///< shallow to deep
    };
    std::vector<GridAreas> grids;  ///< coarsest first: each is painted over the one before
    struct Contour {
        double depth_m = 0.0;
        bool safety = false;
        std::vector<ChartLine> lines;
    };
    std::vector<Contour> contours;  ///< the safety contour last
    std::vector<ChartLine> context;
    std::vector<ChartLine> land;
    std::vector<ChartLine> coast;  ///< beaches, rocks: where the ring of the land is shore
    std::vector<ChartLine> stone;  ///< quays, jetties, breakwaters
    std::vector<chart::ChartMark> marks;
    chart::Extent extent;  ///< of the depths, or of whatever there is

    bool hasDepth(core::NorthEast p) const;
};

/// Contours at 2, 5, 10 and 20 m and the safety contour. `area` may be null: a chart of nothing.
std::shared_ptr<const PreparedChart> prepareChart(std::shared_ptr<const core::Area> area, double safety_m);

}  // namespace sagara::ui
