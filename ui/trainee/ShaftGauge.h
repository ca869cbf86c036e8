#pragma once

#include <vector>

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Revolutions of every shaft as bars, astern to the left, with marks at what was ordered.
class ShaftGauge final : public Gauge {
public:
    /// `most_rps`: full ahead.
    ShaftGauge(const std::vector<QString>& names, double most_rps, QWidget* parent = nullptr);
    void setShaft(std::size_t shaft, double speed_rps, double order_rps);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    struct Shaft {
        QString name;
        double speed_rps = 0.0, order_rps = 0.0;
    };
    std::vector<Shaft> m_shafts;
    double m_most_rps;
};

}  // namespace sagara::ui::console
