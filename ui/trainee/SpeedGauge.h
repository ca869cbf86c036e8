#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Speed over ground with the course, and through the water ahead and athwart.
class SpeedGauge final : public Gauge {
public:
    explicit SpeedGauge(QWidget* parent = nullptr);
    /// The course is true; none when she hardly moves.
    void setOverGround(double speed_mps, std::optional<double> course_rad);
    void setThroughWater(double ahead_mps, double toStarboard_mps);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    double m_overGround_mps = 0.0, m_ahead_mps = 0.0, m_toStarboard_mps = 0.0;
    std::optional<double> m_course_rad;
};

}  // namespace sagara::ui::console
