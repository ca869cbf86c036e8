#pragma once

#include <vector>

#include "ui/widgets/ChartCanvas.h"
#include "ui/widgets/PreparedChart.h"

/// Layers of the area itself: they change only with the view. From the bottom up; labels in the order of
/// their weight.
namespace sagara::ui {

void drawDepthAreas(ChartCanvas& canvas, const PreparedChart& chart);
/// The edge of what the area knows.
void drawDepthLimit(ChartCanvas& canvas, const PreparedChart& chart);
void drawContours(ChartCanvas& canvas, const PreparedChart& chart);
void drawLand(ChartCanvas& canvas, const PreparedChart& chart);
void drawGraticule(ChartCanvas& canvas, const PreparedChart& chart);
void drawBerths(ChartCanvas& canvas, const PreparedChart& chart);
void drawMarks(ChartCanvas& canvas, const PreparedChart& chart);

void labelMarks(ChartCanvas& canvas, const PreparedChart& chart);
void labelBerths(ChartCanvas& canvas, const PreparedChart& chart);
void labelPlaces(ChartCanvas& canvas, const PreparedChart& chart);
void labelContours(ChartCanvas& canvas, const PreparedChart& chart);
void drawSoundings(ChartCanvas& canvas, const PreparedChart& chart);

/// All of them. Gives the boxes of marks and names, which nothing drawn later should cover.
std::vector<QRectF> drawArea(ChartCanvas& canvas, const PreparedChart& chart);

}  // namespace sagara::ui
