#include "ui/vessels/PlotView.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/report/Axis.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

/// The frame of the plot in pixels and what it spans.
struct Frame {
    QRectF box;
    report::Axis across, up;

    double x(double value) const {
        return box.left() + box.width() * (value - across.low) / (across.high - across.low);
    }
    double y(double value) const {
        return box.bottom() - box.height() * (value - up.low) / (up.high - up.low);
    }
    QPointF at(QPointF p) const { return {x(p.x()), y(p.y())}; }
};

/// Widens the axis that has room until a metre is as long in both.
void equalise(report::Axis& a, double pixelsA, report::Axis& b, double pixelsB) {
    const double perA = (a.high - a.low) / pixelsA, perB = (b.high - b.low) / pixelsB;
    const auto widen = [](report::Axis& axis, double span) {
        const double more = 0.5 * (span - (axis.high - axis.low));
        axis.low -= more;
        axis.high += more;
    };
    if (perA < perB)
        widen(a, perB * pixelsA);
    else
        widen(b, perA * pixelsB);
    a.step = b.step = std::max(a.step, b.step);
}

std::vector<double> ticksOf(const report::Axis& axis) {
    std::vector<double> ticks;
    for (double t = std::ceil(axis.low / axis.step - 1e-9) * axis.step; t <= axis.high + 1e-9 * axis.step;
         t += axis.step)
        ticks.push_back(std::abs(t) < 1e-9 * axis.step ? 0.0 : t);
    return ticks;
}

}  // namespace

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlotView::setPlot(Plot plot) {
    m_plot = std::move(plot);
    setAccessibleName(m_plot.title);
    update();
}

void PlotView::setColours(PaletteName name) {
    m_colours = name;
    update();
}

void PlotView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
}

void PlotView::draw(QPainter& painter) const {
    const ThemeColours& c = themeColours(m_colours);
    painter.fillRect(rect(), c.surface);
    QFont text = font(), bold = font();
    text.setPointSizeF(0.88 * font().pointSizeF());
    bold.setBold(true);
    painter.setPen(c.text);
    painter.setFont(bold);
    painter.drawText(QRectF(10, 4, width() - 20, 20), Qt::AlignLeft | Qt::AlignVCenter, m_plot.title);
    painter.setFont(text);
    const QFontMetricsF metrics(text);

    std::vector<double> xs, ys;
    for (const Plot::Series& s : m_plot.series) {
        for (const QPointF p : s.points) {
            xs.push_back(m_plot.xUp ? p.y() : p.x());
            ys.push_back(m_plot.xUp ? p.x() : p.y());
        }
    }
    if (xs.empty()) {
        painter.setPen(c.quietText);
        painter.drawText(rect().adjusted(16, 24, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_plot.empty);
        return;
    }
    for (const Plot::Limit& limit : m_plot.limits) (limit.horizontal ? ys : xs).push_back(1.04 * limit.value);
    // Legend above the frame, axis words outside of it.
    Frame f;
    f.box = QRectF(52, 46, width() - 66, height() - 46 - 38);
    const int ticksAcross = std::clamp(static_cast<int>(f.box.width() / 70.0), 2, 8),
              ticksUp = std::clamp(static_cast<int>(f.box.height() / 42.0), 2, 8);
    f.across = report::axisFor(xs, {.tickCount = ticksAcross, .steps = {}});
    f.up = report::axisFor(ys, {.tickCount = ticksUp, .steps = {}});
    if (m_plot.equalScale) equalise(f.across, f.box.width(), f.up, f.box.height());

    painter.setClipping(false);
    for (const double t : ticksOf(f.across)) {
        painter.setPen(QPen(t == 0.0 ? c.border : c.line, 1.0));
        painter.drawLine(QPointF(f.x(t), f.box.top()), QPointF(f.x(t), f.box.bottom()));
        painter.setPen(c.quietText);
        painter.drawText(QRectF(f.x(t) - 40, f.box.bottom() + 3, 80, 16), Qt::AlignHCenter | Qt::AlignTop,
                         chart::shortNumber(t, 2));
    }
    for (const double t : ticksOf(f.up)) {
        painter.setPen(QPen(t == 0.0 ? c.border : c.line, 1.0));
        painter.drawLine(QPointF(f.box.left(), f.y(t)), QPointF(f.box.right(), f.y(t)));
        painter.setPen(c.quietText);
        painter.drawText(QRectF(0, f.y(t) - 9, f.box.left() - 5, 18), Qt::AlignRight | Qt::AlignVCenter,
                         chart::shortNumber(t, 2));
    }
    painter.setPen(c.quietText);
    painter.drawText(QRectF(f.box.left(), height() - 19, f.box.width(), 17),
                     Qt::AlignHCenter | Qt::AlignVCenter, m_plot.xLabel);
    painter.save();
    painter.translate(11, f.box.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-f.box.height() / 2, -9, f.box.height(), 18), Qt::AlignCenter, m_plot.yLabel);
    painter.restore();

    painter.save();
    painter.setClipRect(f.box.adjusted(-1, -1, 1, 1));
    for (const Plot::Limit& limit : m_plot.limits) {
        painter.setPen(QPen(c.alarm, 1.4, Qt::DashLine));
        if (limit.horizontal)
            painter.drawLine(QPointF(f.box.left(), f.y(limit.value)),
                             QPointF(f.box.right(), f.y(limit.value)));
        else
            painter.drawLine(QPointF(f.x(limit.value), f.box.top()),
                             QPointF(f.x(limit.value), f.box.bottom()));
    }
    double legend_px = f.box.left();
    for (const Plot::Series& s : m_plot.series) {
        QPainterPath path;
        for (const QPointF p : s.points) {
            const QPointF at = f.at(m_plot.xUp ? QPointF(p.y(), p.x()) : p);
            if (path.elementCount() == 0)
                path.moveTo(at);
            else
                path.lineTo(at);
        }
        const QPen pen(c.series[static_cast<std::size_t>(s.colour) % c.series.size()], 1.8,
                       s.dashed ? Qt::DashLine : Qt::SolidLine);
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
        if (s.name.isEmpty()) continue;
        painter.setClipping(false);
        painter.drawLine(QPointF(legend_px, 34), QPointF(legend_px + 20, 34));
        painter.setPen(c.text);
        painter.drawText(QPointF(legend_px + 25, 34 + 0.35 * metrics.ascent()), s.name);
        legend_px += 25 + metrics.horizontalAdvance(s.name) + 16;
        painter.setClipping(true);
    }
    painter.restore();
    // Words of limits last, with paper behind them: they must be read over any line.
    for (const Plot::Limit& limit : m_plot.limits) {
        const double w = metrics.horizontalAdvance(limit.label) + 8, h = metrics.height();
        QRectF label = limit.horizontal ? QRectF(f.box.right() - w - 2, f.y(limit.value) - h - 1, w, h)
                                        : QRectF(f.x(limit.value) - w - 2, f.box.bottom() - h - 4, w, h);
        if (limit.horizontal && limit.value < 0.0) label.moveTop(f.y(limit.value) + 1);
        QColor paper = c.surface;
        paper.setAlphaF(0.85F);
        painter.fillRect(label, paper);
        painter.setPen(c.alarm);
        painter.drawText(label, Qt::AlignCenter, limit.label);
    }
    painter.setPen(QPen(c.border, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(f.box);
}

}  // namespace sagara::ui
