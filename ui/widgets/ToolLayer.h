#pragma once

#include <optional>

#include "core/base/LocalFrame.h"
#include "ui/widgets/ChartCanvas.h"
#include "ui/widgets/ChartTools.h"

/// What is measured and what can be dragged, on top of the chart.
namespace sagara::ui {

void drawTools(ChartCanvas& canvas, const ChartTools& tools, const core::LocalFrame& frame,
               std::optional<core::NorthEast> ownShip);

/// "275°T, 0.35 M 3.5 cables to starboard of the own ship"
QString ruleText(const ChartTools::Rule& rule, const core::LocalFrame& frame,
                 std::optional<core::NorthEast> ownShip);

/// A small square at each; the one that is dragged with a line from where it was.
void drawHandles(ChartCanvas& canvas, const ChartScene& scene, std::optional<std::size_t> dragged,
                 core::NorthEast draggedFrom);

}  // namespace sagara::ui
