#pragma once

#include <QWidget>
#include <vector>

#include "ui/theme/PaletteName.h"

class QPainter;

namespace sagara::ui {

/// What a plot shows. Values are in the units of the labels.
struct Plot {
    struct Series {
        QString name;
        int colour = 0;  ///< of ThemeColours::series
        bool dashed = false;
        std::vector<QPointF> points;
    };
    /// A limit: a line across the plot with its words.
    struct Limit {
        bool horizontal = true;  ///< at a value of y; else at one of x
        double value = 0.0;
        QString label;
    };
    QString title;
    QString xLabel, yLabel;
    bool equalScale = false;  ///< one metre is as long in both directions
    bool xUp = false;         ///< x of the points goes up the page, y to the right: tracks
    std::vector<Series> series;
    std::vector<Limit> limits;
    QString empty;  ///< said where there is nothing to draw
};

/// Draws one plot with axes, legend and limits in the colours of the palette.
class PlotView final : public QWidget {
    Q_OBJECT

public:
    explicit PlotView(QWidget* parent = nullptr);
    void setPlot(Plot plot);
    const Plot& plot() const { return m_plot; }
    void setColours(PaletteName name);
    QSize sizeHint() const override { return {380, 260}; }
    QSize minimumSizeHint() const override { return {220, 150}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void draw(QPainter& painter) const;

    Plot m_plot;
    PaletteName m_colours = PaletteName::Day;
};

}  // namespace sagara::ui
