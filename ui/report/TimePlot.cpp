#include "ui/report/TimePlot.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kTitle_mm = 4.6;  ///< height of the line above the frame
constexpr double kPixel_mm =
    0.08;  ///< finer than a printer's line: changes within it are drawn as one stroke
const TextStyle kTitleStyle{8.5, colour::kInk, true};
const TextStyle kSmallStyle{7.5, colour::kQuiet};
const TextStyle kTickStyle{7.5};

/// First, lowest, highest and last value of all points that share a pixel column.
class Column {
public:
    explicit Column(QPointF p) : m_first(p), m_low(p), m_high(p), m_last(p) {}
    bool takes(QPointF p) const { return p.x() - m_first.x() < kPixel_mm; }
    void add(QPointF p) {
        if (p.y() < m_low.y()) m_low = p;
        if (p.y() > m_high.y()) m_high = p;
        m_last = p;
    }
    void appendTo(QPolygonF& line) const {
        const bool lowFirst = m_low.x() <= m_high.x();
        for (const QPointF& p : {m_first, lowFirst ? m_low : m_high, lowFirst ? m_high : m_low, m_last}) {
            if (line.isEmpty() || line.last() != p) line << p;
        }
    }

private:
    QPointF m_first, m_low, m_high, m_last;
};

/// The same line without points that cannot be told apart in print.
QPolygonF thinned(const QPolygonF& line) {
    if (line.isEmpty()) return line;
    QPolygonF thin;
    Column column(line.first());
    for (const QPointF& p : line) {
        if (!column.takes(p)) {
            column.appendTo(thin);
            column = Column(p);
        }
        column.add(p);
    }
    column.appendTo(thin);
    return thin;
}

void drawSeries(QPainter& painter, const PlotSeries& series, const std::function<QPointF(QPointF)>& onPage) {
    painter.setPen(series.pen);
    QPolygonF line;
    const auto flush = [&] {
        if (line.size() == 1) painter.drawEllipse(line.first(), 0.3, 0.3);
        if (line.size() > 1) painter.drawPolyline(thinned(line));
        line.clear();
    };
    for (const QPointF& p : series.points) {
        if (std::isfinite(p.y()) && std::isfinite(p.x())) {
            line << onPage(p);
        } else {
            flush();
        }
    }
    flush();
}

/// Name and a sample of the line of each series, from the left; gives where it ends.
void drawKey(QPainter& painter, const Plot& plot, QPointF at) {
    const double middle_mm = at.y() - 0.5 * capHeight_mm(kSmallStyle);
    for (const PlotSeries& series : plot.series) {
        if (series.name.isEmpty()) continue;
        painter.setPen(series.pen);
        painter.drawLine(QPointF(at.x(), middle_mm), QPointF(at.x() + 7.0, middle_mm));
        drawText(painter, {at.x() + 8.2, at.y()}, Qt::AlignLeft, series.name, kSmallStyle);
        at.rx() += 8.2 + width_mm(series.name, kSmallStyle) + 4.0;
    }
}

void drawTitle(QPainter& painter, const Plot& plot, const QRectF& frame) {
    const double baseline_mm = frame.top() - 1.3;
    drawText(painter, {frame.left(), baseline_mm}, Qt::AlignLeft, plot.title, kTitleStyle);
    drawText(painter, {frame.right(), baseline_mm}, Qt::AlignRight, plot.remark, kSmallStyle);
    drawKey(painter, plot, {frame.left() + width_mm(plot.title, kTitleStyle) + 6.0, baseline_mm});
}

void drawValueGrid(QPainter& painter, const Plot& plot, const QRectF& frame,
                   const std::function<QPointF(QPointF)>& onPage) {
    for (const double value : plot.axis.ticks()) {
        const double y_mm = onPage({0.0, value}).y();
        const bool zero = std::abs(value) < 1e-9 * plot.axis.step && plot.axis.low < 0.0;
        painter.setPen(zero ? linePen(colour::kQuiet, 0.2) : linePen(colour::kGrid, 0.14));
        painter.drawLine(QPointF(frame.left(), y_mm), QPointF(frame.right(), y_mm));
        drawText(painter, {frame.left() - 1.4, y_mm}, Qt::AlignRight | Qt::AlignVCenter, plot.tickText(value),
                 kTickStyle);
    }
}

void drawTimeGrid(QPainter& painter, const TimeScale& time, const QRectF& frame) {
    painter.setPen(linePen(colour::kGrid, 0.14));
    for (double t_s = timeStep_s(time.end_s); t_s < time.end_s; t_s += timeStep_s(time.end_s)) {
        painter.drawLine(QPointF(time.x_mm(t_s), frame.top()), QPointF(time.x_mm(t_s), frame.bottom()));
    }
}

}  // namespace

double TimeScale::x_mm(double time_s) const {
    return left_mm + width_mm * std::clamp(time_s / end_s, 0.0, 1.0);
}

QRectF plotFrame(const TimeScale& time, double top_mm, double height_mm) {
    return {time.left_mm, top_mm + kTitle_mm, time.width_mm, height_mm - kTitle_mm};
}

void drawPlot(QPainter& painter, const Plot& plot, const TimeScale& time, double top_mm, double height_mm) {
    const QRectF frame = plotFrame(time, top_mm, height_mm);
    const double perUnit_mm = frame.height() / (plot.axis.high - plot.axis.low);
    const auto onPage = [&](QPointF p) {
        return QPointF(time.x_mm(p.x()), frame.bottom() - perUnit_mm * (p.y() - plot.axis.low));
    };
    drawTitle(painter, plot, frame);
    drawTimeGrid(painter, time, frame);
    drawValueGrid(painter, plot, frame, onPage);
    painter.save();
    painter.setClipRect(frame.adjusted(-0.2, -0.2, 0.2, 0.2));
    painter.setBrush(Qt::NoBrush);
    for (const PlotSeries& series : plot.series) drawSeries(painter, series, onPage);
    painter.restore();
    painter.setPen(linePen(colour::kQuiet, 0.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame);
}

}  // namespace sagara::report
