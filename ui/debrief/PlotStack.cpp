#include "ui/debrief/PlotStack.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

constexpr double kLeastPlot_px = 84.0;

/// A curve on the screen. Of many points in one column of pixels only the outermost are kept.
std::vector<QPolygonF> polylines(const PlotData& data, const PlotCurve& curve, const TimeAxis& axis,
                                 double width_px, const QRectF& area, const PlotAxis& y) {
    std::vector<QPolygonF> lines(1);
    if (data.time_s.empty()) return lines;
    const std::size_t first = data.at(axis.from_s());
    const std::size_t last = std::min(data.time_s.size() - 1, data.at(axis.to_s()) + 1);
    const auto toY = [&](float v) {
        return area.bottom() - area.height() * (static_cast<double>(v) - y.low) / (y.high - y.low);
    };
    double column = -1.0, low = 0.0, high = 0.0, end = 0.0;
    const auto flush = [&] {
        if (column < 0.0) return;
        QPolygonF& line = lines.back();
        if (low != high) line << QPointF(column, low) << QPointF(column, high);
        line << QPointF(column, end);
        column = -1.0;
    };
    for (std::size_t i = first; i <= last; ++i) {
        if (!std::isfinite(curve.values[i])) {
            flush();
            if (!lines.back().isEmpty()) lines.emplace_back();
            continue;
        }
        const double x = 0.5 * std::round(2.0 * axis.x(data.time_s[i], width_px)), v = toY(curve.values[i]);
        if (x != column) {
            flush();
            column = x;
            low = high = v;
        }
        low = std::min(low, v);
        high = std::max(high, v);
        end = v;
    }
    flush();
    return lines;
}

}  // namespace

PlotStack::PlotStack(TimeAxis& axis, QWidget* parent)
    : QWidget(parent), m_axis(axis), m_shown{PlotKind::SpeedOverGround, PlotKind::Rudder} {
    setObjectName(QStringLiteral("plots"));
    setAccessibleName(tr("Plots"));
    setToolTip(tr("Click: go to that moment. Ctrl and wheel: zoom in time. Double click: all of the time."));
    connect(&axis, &TimeAxis::rangeChanged, this, &PlotStack::stale);
    connect(&axis, &TimeAxis::cursorChanged, this, qOverload<>(&QWidget::update));
}

void PlotStack::stale() {
    m_picture = {};
    update();
}

void PlotStack::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) stale();
    QWidget::changeEvent(event);
}

void PlotStack::setColours(PaletteName name) {
    m_colours = name;
    stale();
}

void PlotStack::setData(std::shared_ptr<const PlotData> run) {
    m_data = std::move(run);
    stale();
}

void PlotStack::setOther(std::shared_ptr<const PlotData> run) {
    m_other = std::move(run);
    stale();
}

void PlotStack::setMarks(const std::vector<DebriefMark>& marks) {
    m_marks.clear();
    for (const DebriefMark& mark : marks)
        if (mark.kind == MarkKind::Deduction || mark.kind == MarkKind::Failure) m_marks.push_back(mark);
    stale();
}

void PlotStack::setShown(std::vector<PlotKind> kinds) {
    m_shown = std::move(kinds);
    updateGeometry();
    stale();
}

QSize PlotStack::minimumSizeHint() const {
    return {480,
            static_cast<int>(kLeastPlot_px * static_cast<double>(std::max<std::size_t>(1, m_shown.size())))};
}
QSize PlotStack::sizeHint() const { return minimumSizeHint(); }

QRectF PlotStack::plotArea(std::size_t index) const {
    const double each_px = height() / static_cast<double>(std::max<std::size_t>(1, m_shown.size()));
    const double head_px = fontMetrics().height() + 3.0;
    return {TimeAxis::kLeft_px, each_px * static_cast<double>(index) + head_px,
            std::max(1.0, width() - TimeAxis::kLeft_px - TimeAxis::kRight_px), each_px - head_px - 5.0};
}

PlotAxis PlotStack::axisOf(PlotKind kind) const {
    std::vector<const Plot*> plots;
    if (m_data) plots.push_back(&m_data->of(kind));
    if (m_other) plots.push_back(&m_other->of(kind));
    return plotAxis(kind, plots, std::max(1, static_cast<int>(plotArea(0).height() / 14.0)));
}

QPen PlotStack::penOf(const PlotCurve& curve, std::size_t nth, bool other) const {
    const ThemeColours& c = themeColours(m_colours);
    QPen pen(c.series[2 * (nth % 2) + (other ? 1 : 0)], 1.6);
    if (curve.style == PlotCurve::Style::Ordered) {
        pen.setWidthF(1.1);
        pen.setStyle(Qt::DotLine);
    }
    if (curve.style == PlotCurve::Style::Limit) {
        pen.setColor(c.port);
        pen.setWidthF(1.2);
        pen.setStyle(Qt::DashLine);
    }
    return pen;
}

void PlotStack::drawCurves(QPainter& p, const PlotData& run, PlotKind kind, bool other, const QRectF& area,
                           const PlotAxis& axis) const {
    std::size_t plain = 0, ordered = 0;
    for (const PlotCurve& curve : run.of(kind).curves) {
        const bool limit = curve.style == PlotCurve::Style::Limit;
        if (limit && other) continue;
        const bool isOrder = curve.style == PlotCurve::Style::Ordered;
        p.setPen(penOf(curve, limit ? 0 : isOrder ? ordered++ : plain++, other));
        for (const QPolygonF& line : polylines(run, curve, m_axis, width(), area, axis)) p.drawPolyline(line);
    }
}

void PlotStack::drawPlot(QPainter& p, std::size_t index) const {
    const ThemeColours& c = themeColours(m_colours);
    const PlotKind kind = m_shown[index];
    const QRectF area = plotArea(index);
    const PlotAxis axis = axisOf(kind);
    const double line_px = fontMetrics().height();
    p.setPen(c.text);
    p.drawText(QPointF(TimeAxis::kLeft_px, area.top() - 5.0), plotTitle(kind));
    for (double v = axis.low; v <= axis.high + 1e-9; v += axis.step) {
        const double y = area.bottom() - area.height() * (v - axis.low) / (axis.high - axis.low);
        p.setPen(QPen(std::abs(v) < 1e-9 ? c.quietTick : c.line, 1));
        p.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        p.setPen(c.quietText);
        p.drawText(QRectF(0, y - line_px, area.left() - 6, 2 * line_px), Qt::AlignRight | Qt::AlignVCenter,
                   plotFigure(kind, v, axis.decimals));
    }
    const double step_s = m_axis.step_s(width(), 6.0 * fontMetrics().averageCharWidth() + 24.0);
    p.setPen(QPen(c.line, 1));
    for (double t = std::ceil(m_axis.from_s() / step_s) * step_s; t <= m_axis.to_s() + 1e-6; t += step_s)
        p.drawLine(QPointF(m_axis.x(t, width()), area.top()), QPointF(m_axis.x(t, width()), area.bottom()));
    p.save();
    p.setClipRect(area.adjusted(0, -1, 0, 1));
    QColor red = c.port;
    red.setAlpha(120);
    p.setPen(QPen(red, 1));
    for (const DebriefMark& mark : m_marks) {
        const double x = m_axis.x(mark.time.seconds(), width());
        p.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    p.setRenderHint(QPainter::Antialiasing);
    if (m_data) drawCurves(p, *m_data, kind, false, area, axis);
    if (m_other) drawCurves(p, *m_other, kind, true, area, axis);
    p.restore();
}

QString PlotStack::readingOf(const PlotData& run, PlotKind kind) const {
    const double t = m_axis.cursor().seconds();
    if (run.time_s.empty() || t < run.time_s.front() - 0.3 || t > run.time_s.back() + 0.3) return {};
    const std::size_t i = run.at(t);
    QStringList parts;
    for (const PlotCurve& curve : run.of(kind).curves) {
        const double value = static_cast<double>(curve.values[i]);
        if (!std::isfinite(value)) continue;
        const QString figure = plotFigure(kind, value, plotDecimals(kind));
        parts << (curve.name.isEmpty() ? figure : QStringLiteral("%1 %2").arg(curve.name, figure));
    }
    return parts.join(QStringLiteral(", "));
}

QString PlotStack::reading(PlotKind kind) const {
    if (!m_data) return {};
    const QString main = readingOf(*m_data, kind);
    if (!m_other) return main;
    const QString other = readingOf(*m_other, kind);
    return other.isEmpty() ? main : tr("%1   what if: %2").arg(main, other);
}

void PlotStack::paintEvent(QPaintEvent*) {
    const ThemeColours& c = themeColours(m_colours);
    if (m_picture.isNull() && !size().isEmpty()) {
        m_picture = QPixmap(size() * devicePixelRatioF());
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        m_picture.fill(c.surface);
        QPainter p(&m_picture);
        p.setFont(font());
        if (m_shown.empty()) {
            p.setPen(c.quietText);
            p.drawText(rect(), Qt::AlignCenter, tr("No plot is chosen: choose some with \"Plots\"."));
        }
        for (std::size_t i = 0; i < m_shown.size(); ++i) drawPlot(p, i);
    }
    QPainter p(this);
    p.drawPixmap(0, 0, m_picture);
    const double x = m_axis.x(m_axis.cursor().seconds(), width());
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        const QRectF area = plotArea(i);
        if (x >= area.left() - 1.0 && x <= area.right() + 1.0) {
            p.setPen(QPen(c.accent, 2));
            p.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        }
        QFont bold = font();
        bold.setBold(true);
        p.setFont(bold);
        p.setPen(c.text);
        p.drawText(QRectF(area.left(), area.top() - fontMetrics().height() - 3.0, area.width(),
                          fontMetrics().height() + 2.0),
                   Qt::AlignRight | Qt::AlignVCenter, reading(m_shown[i]));
        p.setFont(font());
    }
}

void PlotStack::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        Q_EMIT m_axis.picked(m_axis.timeAt(event->position().x(), width()));
}

void PlotStack::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        Q_EMIT m_axis.picked(m_axis.timeAt(event->position().x(), width()));
}

void PlotStack::mouseDoubleClickEvent(QMouseEvent*) { m_axis.showAll(); }

void PlotStack::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QWidget::wheelEvent(event);
    m_axis.zoom(m_axis.time_s(event->position().x(), width()),
                std::pow(1.25, event->angleDelta().y() / 120.0));
    event->accept();
}

}  // namespace sagara::ui
