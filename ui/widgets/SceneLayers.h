#pragma once

#include "core/base/LocalFrame.h"
#include "ui/widgets/ChartCanvas.h"
#include "ui/widgets/ChartScene.h"

/// Layers of what happens in the area: drawn at every repaint. From the bottom up; labels in the order of
/// their weight.
namespace sagara::ui {

void drawZones(ChartCanvas& canvas, const ChartScene& scene);
void drawSafetyLimits(ChartCanvas& canvas, const ChartScene& scene);
void drawRoute(ChartCanvas& canvas, const ChartScene& scene);
void drawAnchors(ChartCanvas& canvas, const ChartScene& scene);
void drawTracks(ChartCanvas& canvas, const ChartScene& scene);
void drawPredictions(ChartCanvas& canvas, const ChartScene& scene);
void drawTargets(ChartCanvas& canvas, const ChartScene& scene);
void drawOwnShips(ChartCanvas& canvas, const ChartScene& scene);

void labelShips(ChartCanvas& canvas, const ChartScene& scene);
void labelRoute(ChartCanvas& canvas, const ChartScene& scene, const core::LocalFrame& frame);
void labelAnchors(ChartCanvas& canvas, const ChartScene& scene);
void labelZones(ChartCanvas& canvas, const ChartScene& scene);

/// All that the canvas shows. `frame`: for true courses.
void drawScene(ChartCanvas& canvas, const ChartScene& scene, const core::LocalFrame& frame);

}  // namespace sagara::ui
