#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Rudder angle on a scale of port and starboard, with a mark at what was ordered.
class RudderGauge final : public Gauge {
public:
    explicit RudderGauge(double limit_rad, QWidget* parent = nullptr);
    void setRudder(double angle_rad, double order_rad);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    double m_limit_rad;
    double m_angle_rad = 0.0;
    double m_order_rad = 0.0;
};

}  // namespace sagara::ui::console
