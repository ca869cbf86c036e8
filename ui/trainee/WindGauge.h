#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Wind as the anemometer on the mast gives it and as it is: a dial with the bow up.
class WindGauge final : public Gauge {
public:
    explicit WindGauge(QWidget* parent = nullptr);
    /// From where, clockwise from the bow.
    void setRelative(double from_rad, double speed_mps);
    /// From where, true; `heading_rad` true as well, for the dial.
    void setTrue(double from_rad, double speed_mps, double heading_rad);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    double m_relativeFrom_rad = 0.0, m_relative_mps = 0.0;
    double m_trueFrom_rad = 0.0, m_true_mps = 0.0, m_heading_rad = 0.0;
};

}  // namespace sagara::ui::console
