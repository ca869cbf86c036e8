#pragma once

#include "core/base/LocalFrame.h"
#include "ui/widgets/ChartCanvas.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/RouteShape.h"

/// Layers of what happens in the area: drawn at every repaint. From the bottom up; labels in the order of
/// their weight.
namespace sagara::ui {

void drawZones(ChartCanvas& canvas, const ChartScene& scene);
void drawSafetyLimits(ChartCanvas& canvas, const ChartScene& scene);
/// Steps along a route that are fine enough for a view.
double routeStep_m(const ChartTransform& view);
void drawRoute(ChartCanvas& canvas, const ChartScene& scene, const RouteShape& shape);
void drawAnchors(ChartCanvas& canvas, const ChartScene& scene);
void drawSceneMarks(ChartCanvas& canvas, const ChartScene& scene);
void drawTracks(ChartCanvas& canvas, const ChartScene& scene);
void drawPredictions(ChartCanvas& canvas, const ChartScene& scene);
void drawTargets(ChartCanvas& canvas, const ChartScene& scene);
void drawOwnShips(ChartCanvas& canvas, const ChartScene& scene);

void drawForces(ChartCanvas& canvas, const ChartScene& scene);

void labelSceneMarks(ChartCanvas& canvas, const ChartScene& scene);
void labelShips(ChartCanvas& canvas, const ChartScene& scene);
void labelRoute(ChartCanvas& canvas, const ChartScene& scene, const core::LocalFrame& frame);
void labelAnchors(ChartCanvas& canvas, const ChartScene& scene);
void labelZones(ChartCanvas& canvas, const ChartScene& scene);

/// All that the canvas shows. `shape`: of the scene's route; `frame`: for true courses.
void drawScene(ChartCanvas& canvas, const ChartScene& scene, const RouteShape& shape,
               const core::LocalFrame& frame);

}  // namespace sagara::ui
