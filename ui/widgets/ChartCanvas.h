#pragma once

#include <QPainter>
#include <QStringList>

#include "ui/chart/LabelField.h"
#include "ui/widgets/ChartPalette.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/ChartTransform.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {

/// What every layer of a chart is drawn with. Lengths are logical pixels.
struct ChartCanvas {
    ChartCanvas(QPainter& onPainter, const ChartTransform& in, const ChartPalette& with, ChartLayers layers,
                double letters_px, double pixel_mm)
        : painter(onPainter),
          view(in),
          palette(with),
          shown(layers),
          letter_px(letters_px),
          denominator(in.denominator(pixel_mm)),
          frame(QPointF(), in.size()),
          labels(frame, 0.25 * letters_px) {}

    QPainter& painter;
    const ChartTransform& view;
    const ChartPalette& palette;
    ChartLayers shown;
    double letter_px;    ///< size of plain words; symbols go with it
    double denominator;  ///< of the natural scale
    QRectF frame;
    chart::LabelField labels;

    bool shows(ChartLayer layer) const { return shown.testFlag(layer); }
    /// The frame and a little around it, where lines are cut off.
    QRectF clip() const { return frame.adjusted(-40.0, -40.0, 40.0, 40.0); }
    /// Whether a symbol at this place is to be seen.
    bool holds(QPointF p) const { return clip().contains(p); }
    void blockAround(QPointF p, double half_px) {
        labels.block({p.x() - half_px, p.y() - half_px, 2.0 * half_px, 2.0 * half_px});
    }

    Lettering letters(double size, const QColor& colour) const {
        return {size * letter_px, colour, palette.halo, false, false};
    }
};

/// Solid, with round joins; one pixel is the thinnest that reads.
QPen chartPen(const QColor& colour, double width_px, Qt::PenStyle style = Qt::SolidLine);
/// Dash and gap in pixels.
QPen dashedChartPen(const QColor& colour, double width_px, double dash_px, double gap_px);

/// Places and draws a label of some lines within reach of a point, never over another; false when there is no
/// room.
bool labelNear(ChartCanvas& canvas, QPointF at, double gap_px, double reach_px, const QStringList& lines,
               const Lettering& lettering);

/// Words broken into two lines at most, at a blank near the middle, when they are wider than `widest_px`.
QStringList inTwoLines(const QString& words, const Lettering& lettering, double widest_px);

}  // namespace sagara::ui
