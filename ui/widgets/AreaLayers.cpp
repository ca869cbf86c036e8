#include "ui/widgets/AreaLayers.h"

namespace sagara::ui {

std::vector<QRectF> drawArea(ChartCanvas& canvas, const PreparedChart& chart) {
    canvas.painter.fillRect(canvas.frame, canvas.palette.noDepths);
    if (!chart.area) return {};
    drawDepthAreas(canvas, chart);
    if (canvas.shows(ChartLayer::Contours)) drawContours(canvas, chart);
    drawLand(canvas, chart);
    drawDepthLimit(canvas, chart);
    if (canvas.shows(ChartLayer::Graticule)) drawGraticule(canvas, chart);
    if (canvas.shows(ChartLayer::Berths)) drawBerths(canvas, chart);
    if (canvas.shows(ChartLayer::Marks)) {
        drawMarks(canvas, chart);
        labelMarks(canvas, chart);
    }
    if (canvas.shows(ChartLayer::Places)) labelPlaces(canvas, chart);
    if (canvas.shows(ChartLayer::Berths)) labelBerths(canvas, chart);
    std::vector<QRectF> names = canvas.labels.blocked();
    if (canvas.shows(ChartLayer::Contours)) labelContours(canvas, chart);
    if (canvas.shows(ChartLayer::Soundings)) drawSoundings(canvas, chart);
    return names;
}

}  // namespace sagara::ui
