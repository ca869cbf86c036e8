#include "ui/debrief/TimeAxis.h"

#include <algorithm>
#include <cmath>

#include "ui/run/RunTexts.h"

namespace sagara::ui {
namespace {

constexpr double kShortest_s = 10.0;

}  // namespace

QString axisTime(double time_s) { return elapsed(core::SimTime::fromSeconds(std::llround(time_s))); }

void TimeAxis::setWhole(core::SimTime begin, core::SimTime end) {
    const bool all = !zoomed();
    m_begin = begin;
    m_end = std::max(end, core::SimTime{begin.us + 1'000'000});
    if (all)
        showAll();
    else
        setRange(m_from_s, m_to_s);
}

bool TimeAxis::zoomed() const {
    return m_from_s > m_begin.seconds() + 1e-6 || m_to_s < m_end.seconds() - 1e-6;
}

void TimeAxis::setCursor(core::SimTime time) {
    if (m_cursor == time) return;
    m_cursor = time;
    const double t = time.seconds();
    if (t < m_from_s || t > m_to_s) scroll(t - 0.5 * (m_from_s + m_to_s));
    Q_EMIT cursorChanged();
}

void TimeAxis::setRange(double from_s, double to_s) {
    const double begin_s = m_begin.seconds(), end_s = m_end.seconds();
    const double span_s = std::clamp(to_s - from_s, std::min(kShortest_s, end_s - begin_s), end_s - begin_s);
    m_from_s = std::clamp(from_s, begin_s, end_s - span_s);
    m_to_s = m_from_s + span_s;
    Q_EMIT rangeChanged();
}

void TimeAxis::zoom(double about_s, double factor) {
    setRange(about_s - (about_s - m_from_s) / factor, about_s + (m_to_s - about_s) / factor);
}

void TimeAxis::scroll(double by_s) { setRange(m_from_s + by_s, m_to_s + by_s); }

void TimeAxis::showAll() { setRange(m_begin.seconds(), m_end.seconds()); }

double TimeAxis::x(double time_s, double width_px) const {
    return kLeft_px + (width_px - kLeft_px - kRight_px) * (time_s - m_from_s) / (m_to_s - m_from_s);
}

double TimeAxis::time_s(double x_px, double width_px) const {
    const double plot_px = std::max(1.0, width_px - kLeft_px - kRight_px);
    return m_from_s + (m_to_s - m_from_s) * (x_px - kLeft_px) / plot_px;
}

core::SimTime TimeAxis::timeAt(double x_px, double width_px) const {
    const auto ticks = std::llround(time_s(x_px, width_px) / core::kTick_s);
    return std::clamp(core::timeOfTick(ticks), m_begin, m_end);
}

double TimeAxis::step_s(double width_px, double apart_px) const {
    const double perSecond_px = (width_px - kLeft_px - kRight_px) / (m_to_s - m_from_s);
    for (const double step :
         {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0})
        if (step * perSecond_px >= apart_px) return step;
    return 7200.0;
}

}  // namespace sagara::ui
