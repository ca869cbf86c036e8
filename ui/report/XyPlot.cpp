#include "ui/report/XyPlot.h"

#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/report/Axis.h"
#include "ui/report/Style.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

const TextStyle kTitleStyle{8.0, colour::kInk, true};
const TextStyle kSmallStyle{7.0, colour::kQuiet};
constexpr double kLeft_mm = 11.0, kTop_mm = 5.0, kBelow_mm = 12.0;
constexpr double kCircle_mm = 0.8, kApart_mm = 2.6;
const std::array kColours{colour::kRoute, colour::kHostile, colour::kPassed, colour::kOther};

/// Values on the page.
struct Frame {
    QRectF area;
    Axis x, y;
    QPointF at(QPointF p) const {
        return {area.left() + area.width() * (p.x() - x.low) / (x.high - x.low),
                area.bottom() - area.height() * (p.y() - y.low) / (y.high - y.low)};
    }
};

bool finite(QPointF p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }

Axis axisOf(const XyPlot& plot, double (*valueOf)(QPointF)) {
    std::vector<double> values;
    for (const auto& series : plot.series)
        for (const QPointF p : series.at)
            if (finite(p)) values.push_back(valueOf(p));
    if (values.empty()) return {};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    AxisRule rule;
    rule.least = std::min(0.0, *high);
    rule.most = std::max(0.0, *low);
    rule.tickCount = 5;
    return axisFor(values, rule);
}

Frame frameFor(const XyPlot& plot, const QRectF& area) {
    Frame frame{area.adjusted(kLeft_mm, kTop_mm, -2.0, -kBelow_mm),
                axisOf(plot, [](QPointF p) { return p.x(); }), axisOf(plot, [](QPointF p) { return p.y(); })};
    if (!plot.sameScale) return frame;
    const double perMm = std::max((frame.x.high - frame.x.low) / frame.area.width(),
                                  (frame.y.high - frame.y.low) / frame.area.height());
    frame.area.setWidth((frame.x.high - frame.x.low) / perMm);
    frame.area.setTop(frame.area.bottom() - (frame.y.high - frame.y.low) / perMm);
    return frame;
}

void drawAxes(QPainter& painter, const XyPlot& plot, const Frame& f) {
    painter.setPen(linePen(colour::kGrid, 0.15));
    for (const double x : f.x.ticks()) painter.drawLine(f.at({x, f.y.low}), f.at({x, f.y.high}));
    for (const double y : f.y.ticks()) painter.drawLine(f.at({f.x.low, y}), f.at({f.x.high, y}));
    for (const double x : f.x.ticks())
        drawText(painter, f.at({x, f.y.low}) + QPointF(0.0, 3.2), Qt::AlignHCenter,
                 QString::number(x, 'g', 5), kSmallStyle);
    for (const double y : f.y.ticks())
        drawText(painter, f.at({f.x.low, y}) - QPointF(1.0, 0.0), Qt::AlignRight | Qt::AlignVCenter,
                 QString::number(y, 'g', 5), kSmallStyle);
    drawText(painter, {f.area.right(), f.area.bottom() + 6.2}, Qt::AlignRight, fromStd(plot.xTitle),
             kSmallStyle);
    drawText(painter, {f.area.left(), f.area.top() - 1.2}, Qt::AlignLeft, fromStd(plot.yTitle), kSmallStyle);
    painter.setPen(linePen(colour::kRule, 0.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(f.area);
}

void drawSeries(QPainter& painter, const XyPlot::Series& series, const Frame& f, const QColor& colour) {
    painter.setPen(linePen(colour, series.points ? 0.2 : 0.4));
    painter.setBrush(Qt::NoBrush);
    QPolygonF line;
    QPointF last(-1e9, -1e9);
    for (const QPointF p : series.at) {
        if (!finite(p)) continue;
        const QPointF here = f.at(p);
        if (!series.points) line << here;
        if (!series.points || std::hypot(here.x() - last.x(), here.y() - last.y()) < kApart_mm) continue;
        painter.drawEllipse(here, kCircle_mm, kCircle_mm);
        last = here;
    }
    if (line.size() > 1) painter.drawPolyline(line);
}

}  // namespace

void drawXyPlot(QPainter& painter, const XyPlot& plot, const QRectF& area) {
    const Frame f = frameFor(plot, area);
    drawText(painter, {area.left(), area.top() + 0.5}, Qt::AlignLeft,
             elided(fromStd(plot.title), kTitleStyle, area.width()), kTitleStyle);
    drawAxes(painter, plot, f);
    QPointF key(f.area.left(), f.area.bottom() + 10.0);
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const XyPlot::Series& series = plot.series[i];
        const QColor colour = series.points ? colour::kInk : kColours[i % kColours.size()];
        drawSeries(painter, series, f, colour);
        const double middle_mm = key.y() - 0.5 * capHeight_mm(kSmallStyle);
        painter.setPen(linePen(colour, series.points ? 0.2 : 0.4));
        if (series.points) painter.drawEllipse(QPointF(key.x() + 2.5, middle_mm), kCircle_mm, kCircle_mm);
        if (!series.points) painter.drawLine(QPointF(key.x(), middle_mm), QPointF(key.x() + 5.0, middle_mm));
        drawText(painter, {key.x() + 6.0, key.y()}, Qt::AlignLeft, fromStd(series.name), kSmallStyle);
        key.rx() += 9.0 + width_mm(fromStd(series.name), kSmallStyle);
    }
}

}  // namespace sagara::report
