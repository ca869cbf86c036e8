#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <optional>
#include <string>
#include <vector>

namespace sagara::report {

/// Lines and points over two axes. Plain values. Lines differ by colour and dashes, points by their shape.
struct XyPlot {
    struct Series {
        std::string name;
        bool points = false;  ///< measured or published; else a line
        std::vector<QPointF> at;
        /// Which colour and dashes, or shape: the same in plots side by side. None: by its place here.
        std::optional<std::size_t> look = {};
    };
    std::string title;
    std::string xTitle;
    std::string yTitle;
    bool sameScale = false;  ///< of both axes: tracks
    std::vector<Series> series;
    std::optional<double> yMost;  ///< what is higher is cut off
    std::string note;             ///< below the key
};

/// Title, frame with ticks, lines, points (thinned where they would touch), a key and a note below.
void drawXyPlot(QPainter& painter, const XyPlot& plot, const QRectF& area);

}  // namespace sagara::report
