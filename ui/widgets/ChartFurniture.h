#pragma once

#include <QString>
#include <QStringList>

#include "ui/widgets/ChartCanvas.h"
#include "ui/widgets/PreparedChart.h"

/// What lies along the edges of the chart: scale, north, degrees and minutes, and the strip of readings
/// below.
namespace sagara::ui {

/// Words of the strip, each pair one below the other.
struct ChartReadout {
    QString position;  ///< under the cursor
    QString depth;
    QString measured;  ///< range and bearing, or the rule
    QString measuredFrom;
    QString notice;  ///< "not for navigation"
    QString source;  ///< of the depths
};

/// Height of the strip in pixels; the chart ends above it.
double readoutHeight_px(double letter_px);
void drawReadout(ChartCanvas& canvas, const QRectF& strip, const ChartReadout& words);

/// Scale bar in cables or miles, natural scale, an arrow to true north, and what is up.
/// The place it takes.
QRectF scaleBox(const ChartCanvas& canvas);
void drawScaleBox(ChartCanvas& canvas, const core::LocalFrame& frame, bool headUp);
/// Latitudes and longitudes where the lines of the graticule come to the edge.
void drawGraticuleTexts(ChartCanvas& canvas, const core::LocalFrame& frame);
/// In the middle of a chart that has nothing to show.
void drawEmptyNote(ChartCanvas& canvas, const QStringList& lines);

}  // namespace sagara::ui
