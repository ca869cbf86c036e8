#include "ui/trainer/TraceBoard.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/theme/ThemeColours.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {
namespace {

/// How a trace is written: the least that its axis shows either way, so that a calm is a calm.
struct Look {
    const char* name;
    const char* unit;
    int decimals;
    double least;
};
constexpr std::array<Look, kTraces> kLooks{
    {{QT_TRANSLATE_NOOP("sagara::ui", "Surge"), "kn", 1, 2.0},
     {QT_TRANSLATE_NOOP("sagara::ui", "Sway"), "kn", 2, 0.5},
     {QT_TRANSLATE_NOOP("sagara::ui", "Heave, up"), "m", 2, 0.5},
     {QT_TRANSLATE_NOOP("sagara::ui", "Roll, to starboard"), "°", 1, 2.0},
     {QT_TRANSLATE_NOOP("sagara::ui", "Pitch, bow up"), "°", 1, 1.0},
     {QT_TRANSLATE_NOOP("sagara::ui", "Yaw, to starboard"), "°/min", 0, 10.0},
     {QT_TRANSLATE_NOOP("sagara::ui", "Drift angle"), "°", 1, 2.0},
     {QT_TRANSLATE_NOOP("sagara::ui", "Speed kept in the turn"), "%", 0, 10.0}}};
const Look& lookOf(Trace trace) { return kLooks[static_cast<std::size_t>(trace)]; }

struct Span {
    double low;
    double high;
};

/// All values seen, zero and the least of the look; in steps, so that the axis does not creep.
Span spanOf(const std::vector<TraceSeries::Sample>& samples, double from_s, std::size_t trace) {
    double low = static_cast<Trace>(trace) == Trace::SpeedKept ? 0.0 : -kLooks[trace].least;
    double high = kLooks[trace].least;
    for (const TraceSeries::Sample& s : samples) {
        const double value = s.values[trace];
        if (s.time_s < from_s || std::isnan(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    const double step = kLooks[trace].least;
    return {step * std::floor(low / step), step * std::ceil(high / step)};
}

}  // namespace

TraceBoard::TraceBoard(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("traces"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(QObject::tr("Traces of the ship's motions"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TraceBoard::setColours(PaletteName name) {
    m_palette = name;
    update();
}

void TraceBoard::setSpan(double span_s) {
    m_span_s = span_s;
    update();
}

QString TraceBoard::title(Trace trace) { return ui::tr(lookOf(trace).name); }

QString TraceBoard::valueNow(Trace trace) const {
    const double value = m_series == nullptr || m_series->samples().empty()
                             ? std::nan("")
                             : m_series->samples().back().values[static_cast<std::size_t>(trace)];
    if (std::isnan(value)) return QStringLiteral("–");
    return chart::number(value, lookOf(trace).decimals) + QChar(0x202f) +
           QString::fromUtf8(lookOf(trace).unit);
}

void TraceBoard::paintEvent(QPaintEvent*) {
    const ThemeColours& c = themeColours(m_palette);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), c.surface);
    constexpr double kFoot = 18.0, kHead = 16.0;
    const double high = (height() - kFoot) / static_cast<double>(kTraces);
    const Lettering words{11.0, c.text, c.section, false, false};
    const Lettering strong{11.0, c.text, c.section, true, false};
    const Lettering quiet{9.5, c.quietText, QColor(0, 0, 0, 0), false, false};
    static const std::vector<TraceSeries::Sample> kNone;
    const auto& samples = m_series == nullptr ? kNone : m_series->samples();
    const double now_s = samples.empty() ? 0.0 : samples.back().time_s, from_s = now_s - m_span_s;
    const double left = 34.0, wide = width() - left - 6.0;
    const auto x = [&](double time_s) { return left + wide * (time_s - from_s) / m_span_s; };

    const auto first = std::lower_bound(samples.begin(), samples.end(), from_s,
                                        [](const auto& s, double t) { return s.time_s < t; });
    for (std::size_t i = 0; i < kTraces; ++i) {
        const auto trace = static_cast<Trace>(i);
        const double top = high * static_cast<double>(i);
        const QRectF box(left, top + 1.0, wide, high - 4.0);
        painter.fillRect(box, c.section);
        const Span span = spanOf(samples, from_s, i);
        const auto y = [&](double value) {
            return box.bottom() - box.height() * (value - span.low) / (span.high - span.low);
        };
        painter.setPen(QPen(c.line, 1.0));
        painter.drawLine(QPointF(box.left(), y(0.0)), QPointF(box.right(), y(0.0)));
        drawText(painter, {left - 4.0, box.top() + 4.0}, Qt::AlignRight | Qt::AlignVCenter,
                 chart::shortNumber(span.high, 1), quiet);
        drawText(painter, {left - 4.0, box.bottom() - 4.0}, Qt::AlignRight | Qt::AlignVCenter,
                 chart::shortNumber(span.low, 1), quiet);
        QPainterPath path;
        bool drawing = false;
        double last_px = -10.0;
        for (auto it = first; it != samples.end(); ++it) {
            const double value = it->values[i];
            if (std::isnan(value)) {
                drawing = false;
                continue;
            }
            const QPointF at(x(it->time_s), y(value));
            if (drawing && at.x() - last_px < 0.5) continue;
            drawing ? path.lineTo(at) : path.moveTo(at);
            drawing = true;
            last_px = at.x();
        }
        painter.setPen(QPen(c.series[i % c.series.size()], 1.7));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
        drawText(painter, {left + 4.0, box.top() + 0.5 * kHead}, Qt::AlignVCenter, title(trace), words);
        drawText(painter, {box.right() - 4.0, box.top() + 0.5 * kHead}, Qt::AlignRight | Qt::AlignVCenter,
                 valueNow(trace), strong);
    }
    for (const double part : {0.0, 0.5, 1.0}) {
        const double back_s = m_span_s * (1.0 - part);
        const QString text = back_s == 0.0 ? ui::tr("now") : ui::tr("%1 s ago").arg(back_s, 0, 'f', 0);
        const Qt::Alignment side = part == 0.0   ? Qt::AlignLeft
                                   : part == 1.0 ? Qt::AlignRight
                                                 : Qt::AlignHCenter;
        drawText(painter, {left + part * wide, height() - 0.5 * kFoot}, side | Qt::AlignVCenter, text, quiet);
    }
}

}  // namespace sagara::ui
