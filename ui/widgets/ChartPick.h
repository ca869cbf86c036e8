#pragma once

#include <QString>
#include <cstddef>

#include "ui/widgets/ChartScene.h"
#include "ui/widgets/ChartTransform.h"
#include "ui/widgets/PreparedChart.h"

namespace sagara::ui {

/// What lies under a point of the chart.
struct ChartPick {
    enum class Kind { Nothing, OwnShip, Target, Waypoint, SceneMark, Mark, Anchor, Berth, Place, Zone };
    Kind kind = Kind::Nothing;
    std::size_t index = 0;  ///< in the scene's or the area's list of its kind
    core::NorthEast position;
    QString text;  ///< for a tooltip: name, and what there is to know
};

/// The nearest thing within `reach_px`; ships before waypoints, marks, anchors, berths, places and zones.
/// Only layers that are shown. Ships drawn to scale are hit anywhere in their hull.
ChartPick pickOnChart(const PreparedChart& chart, const ChartScene& scene, ChartLayers shown,
                      const ChartTransform& view, QPointF at, double reach_px);

}  // namespace sagara::ui
