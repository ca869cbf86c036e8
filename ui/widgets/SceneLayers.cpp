#include "ui/widgets/SceneLayers.h"

namespace sagara::ui {

void drawScene(ChartCanvas& canvas, const ChartScene& scene, const RouteShape& shape,
               const core::LocalFrame& frame) {
    if (canvas.shows(ChartLayer::Zones)) drawZones(canvas, scene);
    if (canvas.shows(ChartLayer::SafetyLimits)) drawSafetyLimits(canvas, scene);
    if (canvas.shows(ChartLayer::Route)) drawRoute(canvas, scene, shape);
    if (canvas.shows(ChartLayer::Anchors)) drawAnchors(canvas, scene);
    if (canvas.shows(ChartLayer::Marks)) drawSceneMarks(canvas, scene);
    if (canvas.shows(ChartLayer::Targets)) drawTargets(canvas, scene);
    if (canvas.shows(ChartLayer::Track)) drawTracks(canvas, scene);
    if (canvas.shows(ChartLayer::Prediction)) drawPredictions(canvas, scene);
    if (canvas.shows(ChartLayer::OwnShips)) drawOwnShips(canvas, scene);

    if (canvas.shows(ChartLayer::Marks)) labelSceneMarks(canvas, scene);
    if (canvas.shows(ChartLayer::Names)) labelShips(canvas, scene);
    if (canvas.shows(ChartLayer::Route)) labelRoute(canvas, scene, frame);
    if (canvas.shows(ChartLayer::Anchors)) labelAnchors(canvas, scene);
    if (canvas.shows(ChartLayer::Zones)) labelZones(canvas, scene);
    if (canvas.shows(ChartLayer::Forces)) drawForces(canvas, scene);
}

}  // namespace sagara::ui
