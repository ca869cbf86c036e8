#pragma once

#include <deque>

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// What an echo sounder has heard, for its trace: once a second, the last ten minutes.
class SounderTrace {
public:
    struct Sounding {
        double time_s = 0.0;
        std::optional<double> depth_m;
    };
    static constexpr double kKept_s = 600.0;
    /// A time before the last, after a jump back, starts anew.
    void add(double time_s, std::optional<double> depth_m);
    const std::deque<Sounding>& soundings() const { return m_soundings; }
    /// The smallest of the sounder's scales that holds all of the last `span_s`.
    double scale_m(double span_s) const;

private:
    std::deque<Sounding> m_soundings;
};

/// The scrolling picture of an echo sounder: the bottom under the keel against time, now at the right.
class SounderView final : public Gauge {
    Q_OBJECT

public:
    explicit SounderView(QWidget* parent = nullptr);
    void setAlarm(double depth_m);
    double alarm_m() const { return m_alarm_m; }
    void setSpan(double span_s);
    void add(double time_s, std::optional<double> depth_m);
    const SounderTrace& trace() const { return m_trace; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void drawTrace(QPainter& painter, const QRectF& box, double scale_m) const;

    SounderTrace m_trace;
    double m_alarm_m = 2.0;
    double m_span_s = 300.0;
};

}  // namespace sagara::ui::console
