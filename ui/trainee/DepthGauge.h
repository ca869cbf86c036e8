#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Water under the keel as the echo sounder has it, red when it is less than the alarm is set to.
class DepthGauge final : public Gauge {
public:
    explicit DepthGauge(QWidget* parent = nullptr);
    void setDepth(std::optional<double> underKeel_m, double alarm_m);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    std::optional<double> m_underKeel_m;
    double m_alarm_m = 0.0;
};

}  // namespace sagara::ui::console
