#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Tape of the compass about the heading with course made good and the heading the autopilot steers, and
/// below it the rate of turn.
class HeadingGauge final : public Gauge {
public:
    explicit HeadingGauge(QWidget* parent = nullptr);
    /// Directions are true.
    void setHeading(double heading_rad, double turn_radps);
    void setCourse(std::optional<double> course_rad) { m_course_rad = course_rad; }
    void setOrdered(std::optional<double> heading_rad) { m_ordered_rad = heading_rad; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void drawTape(QPainter& painter, const QRectF& box) const;
    void drawTurn(QPainter& painter, const QRectF& box) const;

    double m_heading_rad = 0.0;
    double m_turn_radps = 0.0;
    std::optional<double> m_course_rad, m_ordered_rad;
};

}  // namespace sagara::ui::console
