#include "ui/trainee/SounderView.h"

#include <algorithm>
#include <cmath>

#include "ui/chart/Format.h"

namespace sagara::ui::console {

void SounderTrace::add(double time_s, std::optional<double> depth_m) {
    if (!m_soundings.empty()) {
        const double last_s = m_soundings.back().time_s;
        if (time_s < last_s)
            m_soundings.clear();
        else if (time_s - last_s < 1.0)
            return;
    }
    m_soundings.push_back({time_s, depth_m});
    while (m_soundings.front().time_s < time_s - kKept_s) m_soundings.pop_front();
}

double SounderTrace::scale_m(double span_s) const {
    double deepest_m = 0.0;
    for (const Sounding& s : m_soundings)
        if (s.time_s >= m_soundings.back().time_s - span_s)
            deepest_m = std::max(deepest_m, s.depth_m.value_or(0.0));
    for (const double scale_m : {5.0, 10.0, 20.0, 50.0, 100.0})
        if (deepest_m <= 0.9 * scale_m) return scale_m;
    return 200.0;
}

SounderView::SounderView(QWidget* parent) : Gauge(tr("Echo sounder: metres under the keel"), 1.4, parent) {
    setObjectName(QStringLiteral("sounder"));
    setToolTip(
        tr("Depth under the transducer at the keel in metres against time, now at the right; the dashed "
           "line is the alarm"));
}

void SounderView::setAlarm(double depth_m) {
    m_alarm_m = depth_m;
    update();
}

void SounderView::setSpan(double span_s) {
    m_span_s = span_s;
    update();
}

void SounderView::add(double time_s, std::optional<double> depth_m) {
    m_trace.add(time_s, depth_m);
    update();
}

void SounderView::drawTrace(QPainter& painter, const QRectF& box, double scale_m) const {
    const auto& soundings = m_trace.soundings();
    const double now_s = soundings.back().time_s;
    const auto at = [&](const SounderTrace::Sounding& s) {
        return QPointF(box.right() - (now_s - s.time_s) / m_span_s * box.width(),
                       box.top() + std::min(1.0, *s.depth_m / scale_m) * box.height());
    };
    painter.save();
    painter.setClipRect(box);
    QPolygonF run;
    const auto finish = [&] {
        if (run.size() == 1) run.prepend(run.front() - QPointF(2.0, 0.0));
        if (run.size() > 1) {
            QPolygonF ground = run;
            ground << QPointF(run.back().x(), box.bottom() + 2.0)
                   << QPointF(run.front().x(), box.bottom() + 2.0);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colours().pressed);
            painter.drawPolygon(ground);
            painter.setPen(QPen(colours().accent, 2.2));
            painter.setBrush(Qt::NoBrush);
            painter.drawPolyline(run);
        }
        run.clear();
    };
    for (const SounderTrace::Sounding& s : soundings) {
        if (s.time_s < now_s - m_span_s - 1.0) continue;
        if (s.depth_m)
            run << at(s);
        else
            finish();
    }
    finish();
    painter.restore();
}

void SounderView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF frame = drawFrame(painter);
    const double letters = std::clamp(0.045 * height(), 10.0, 18.0);
    const auto& soundings = m_trace.soundings();
    if (soundings.empty()) {
        drawWords(painter, frame, Qt::AlignCenter, tr("The trace begins when the exercise runs."), letters,
                  colours().quietText);
        return;
    }
    const auto& depth_m = soundings.back().depth_m;
    const bool shallow = depth_m && *depth_m < m_alarm_m;
    const QRectF value(frame.left(), frame.top(), frame.width(), 2.6 * letters);
    if (shallow)
        painter.fillRect(QRectF(value.left(), value.top(), 9.0 * letters, value.height()), colours().alarm);
    drawWords(painter, value, Qt::AlignLeft | Qt::AlignVCenter,
              depth_m ? tr("%1 m").arg(chart::number(std::floor(*depth_m * 10.0) / 10.0, 1)) : tr("no echo"),
              2.3 * letters, shallow ? colours().onAlarm : colours().text, true);
    const double scale_m = m_trace.scale_m(m_span_s);
    drawWords(painter, value, Qt::AlignRight | Qt::AlignVCenter,
              tr("scale %1 m, %2 min").arg(scale_m, 0, 'f', 0).arg(m_span_s / 60.0, 0, 'f', 0), letters,
              colours().quietText);
    const QRectF box = frame.adjusted(2.6 * letters, 2.8 * letters, -2.0, -2.0);
    painter.fillRect(box, colours().window);
    drawTrace(painter, box, scale_m);
    for (int i = 0; i <= 5; ++i) {
        const double y = box.top() + 0.2 * i * box.height();
        painter.setPen(QPen(colours().line, 1.0));
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
        drawWords(painter, QRectF(frame.left(), y - letters, 2.3 * letters, 2.0 * letters),
                  Qt::AlignRight | Qt::AlignVCenter, QString::number(0.2 * i * scale_m), letters,
                  colours().quietText);
    }
    for (double minute = 60.0; minute < m_span_s; minute += 60.0) {
        const double x = box.right() - minute / m_span_s * box.width();
        painter.setPen(QPen(colours().line, 1.0));
        painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
    }
    if (m_alarm_m < scale_m) {
        const double y = box.top() + m_alarm_m / scale_m * box.height();
        const bool dark = contrast(colours().alarm, colours().window) < 3.0;  // by night
        painter.setPen(QPen(dark ? colours().caution : colours().alarm, 1.8, Qt::DashLine));
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    }
}

}  // namespace sagara::ui::console
