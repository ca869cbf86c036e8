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
constexpr double kLeft_mm = 11.0, kTop_mm = 7.5, kTicks_mm = 8.0, kKeyRow_mm = 3.6;
constexpr double kCircle_mm = 0.8, kApart_mm = 2.6;
constexpr double kSample_mm = 7.0, kSampleGap_mm = 1.0, kEntryGap_mm = 3.0;  // of the key

/// A line's colour and its dashes and gaps in widths of the line; none: drawn through.
struct LineLook {
    QColor colour;
    std::vector<qreal> dashes;
};
const std::array<LineLook, 8> kLooks{{{colour::kRoute, {}},
                                      {colour::kHostile, {5.0, 2.0}},
                                      {colour::kPassed, {2.0, 1.5}},
                                      {QColor(0xb4, 0x5f, 0x06), {7.0, 2.0, 1.5, 2.0}},
                                      {colour::kFailed, {1.0, 1.5}},
                                      {QColor(0x00, 0x80, 0x8a), {9.0, 3.0}},
                                      {colour::kInk, {}},
                                      {QColor(0x6a, 0x4c, 0x93), {4.0, 1.5, 1.0, 1.5, 1.0, 1.5}}}};

QPen penOf(const LineLook& look, double width_mm) {
    QPen pen = linePen(look.colour, width_mm);
    if (!look.dashes.empty()) pen.setDashPattern(QList<qreal>(look.dashes.begin(), look.dashes.end()));
    return pen;
}

/// The first series of points are circles, then squares, triangles, crosses.
void drawPoint(QPainter& painter, QPointF at, std::size_t kind) {
    const double r = kCircle_mm;
    switch (kind % 4) {
        case 0:
            painter.drawEllipse(at, r, r);
            break;
        case 1:
            painter.drawRect(QRectF(at.x() - 0.85 * r, at.y() - 0.85 * r, 1.7 * r, 1.7 * r));
            break;
        case 2: {
            const QPointF corners[] = {at + QPointF(0.0, -1.2 * r), at + QPointF(1.1 * r, 0.8 * r),
                                       at + QPointF(-1.1 * r, 0.8 * r)};
            painter.drawPolygon(corners, 3);
            break;
        }
        default:
            painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
            painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
    }
}

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

Axis axisOf(const XyPlot& plot, double (*valueOf)(QPointF), std::optional<double> cutAt = {}) {
    std::vector<double> values;
    for (const auto& series : plot.series)
        for (const QPointF p : series.at)
            if (finite(p)) values.push_back(std::min(valueOf(p), cutAt.value_or(valueOf(p))));
    if (values.empty()) return {};
    // What is nearly nothing below zero asks for no tick of its own.
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double margin = 0.02 * (*most - *least);
    for (double& value : values)
        if (value < 0.0 && value > -margin) value = 0.0;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    AxisRule rule;
    rule.least = std::min(0.0, *high);
    rule.most = std::max(0.0, *low);
    rule.tickCount = 5;
    return axisFor(values, rule);
}

Frame frameFor(const XyPlot& plot, const QRectF& area, double below_mm) {
    Frame frame{area.adjusted(kLeft_mm, kTop_mm, -2.0, -below_mm),
                axisOf(plot, [](QPointF p) { return p.x(); }),
                axisOf(
                    plot, [](QPointF p) { return p.y(); }, plot.yMost)};
    if (!plot.sameScale) return frame;
    const double perMm = std::max((frame.x.high - frame.x.low) / frame.area.width(),
                                  (frame.y.high - frame.y.low) / frame.area.height());
    frame.area.setWidth((frame.x.high - frame.x.low) / perMm);
    frame.area.setHeight((frame.y.high - frame.y.low) / perMm);
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

void drawSeries(QPainter& painter, const XyPlot::Series& series, const Frame& f, std::size_t kind) {
    painter.setBrush(Qt::NoBrush);
    if (!series.points) {
        QPolygonF line;
        for (const QPointF p : series.at)
            if (finite(p)) line << f.at(p);
        painter.setPen(penOf(kLooks[kind % kLooks.size()], 0.4));
        if (line.size() > 1) painter.drawPolyline(line);
        return;
    }
    painter.setPen(linePen(colour::kInk, 0.2));
    QPointF last(-1e9, -1e9);
    for (const QPointF p : series.at) {
        if (!finite(p)) continue;
        const QPointF here = f.at(p);
        if (std::hypot(here.x() - last.x(), here.y() - last.y()) < kApart_mm) continue;
        drawPoint(painter, here, kind);
        last = here;
    }
}

/// An entry of the key: which of the lines or of the points, and where.
struct KeyEntry {
    std::size_t kind;
    QPointF at;  ///< from the key's top left corner
};
struct Key {
    std::vector<KeyEntry> entries;  ///< one for each series
    double height_mm = 0.0;
};

Key keyOf(const XyPlot& plot, double width) {
    Key key;
    QPointF at(0.0, 0.0);
    std::size_t lines = 0, points = 0;
    for (const XyPlot::Series& series : plot.series) {
        const double wide_mm = kSample_mm + kSampleGap_mm + width_mm(fromStd(series.name), kSmallStyle);
        if (at.x() > 0.0 && at.x() + wide_mm > width) at = {0.0, at.y() + kKeyRow_mm};
        const std::size_t place = series.points ? points++ : lines++;
        key.entries.push_back({series.look.value_or(place), at});
        at.rx() += wide_mm + kEntryGap_mm;
    }
    key.height_mm = at.y() + kKeyRow_mm;
    return key;
}

void drawKey(QPainter& painter, const XyPlot& plot, const Key& key, QPointF topLeft) {
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const XyPlot::Series& series = plot.series[i];
        const QPointF at = topLeft + key.entries[i].at + QPointF(0.0, 0.5 * kKeyRow_mm);
        painter.setBrush(Qt::NoBrush);
        if (series.points) {
            painter.setPen(linePen(colour::kInk, 0.2));
            drawPoint(painter, at + QPointF(0.5 * kSample_mm, 0.0), key.entries[i].kind);
        } else {
            painter.setPen(penOf(kLooks[key.entries[i].kind % kLooks.size()], 0.4));
            painter.drawLine(at, at + QPointF(kSample_mm, 0.0));
        }
        drawText(painter, at + QPointF(kSample_mm + kSampleGap_mm, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                 fromStd(series.name), kSmallStyle);
    }
}

}  // namespace

void drawXyPlot(QPainter& painter, const XyPlot& plot, const QRectF& area) {
    const Key key = keyOf(plot, area.width() - kLeft_mm);
    const TextBlock note(fromStd(plot.note), kSmallStyle, area.width() - kLeft_mm, 6);
    const double note_mm = plot.note.empty() ? 0.0 : note.height_mm() + 0.5;
    const Frame f = frameFor(plot, area, kTicks_mm + key.height_mm + note_mm);
    drawText(painter, {area.left(), area.top() + 0.5}, Qt::AlignLeft,
             elided(fromStd(plot.title), kTitleStyle, area.width()), kTitleStyle);
    drawAxes(painter, plot, f);
    painter.save();
    if (plot.yMost) painter.setClipRect(f.area, Qt::IntersectClip);
    for (std::size_t i = 0; i < plot.series.size(); ++i)
        drawSeries(painter, plot.series[i], f, key.entries[i].kind);
    painter.restore();
    const QPointF below(area.left() + kLeft_mm, f.area.bottom() + kTicks_mm);
    drawKey(painter, plot, key, below);
    if (note_mm > 0.0) note.draw(painter, below + QPointF(0.0, key.height_mm + 0.5));
}

}  // namespace sagara::report
