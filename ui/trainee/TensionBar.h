#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Tension of a line against its breaking load: caution from half of it, alarm from four fifths.
class TensionBar final : public Gauge {
public:
    explicit TensionBar(double breaking_N, QWidget* parent = nullptr);
    void setTension(double tension_N);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    double m_breaking_N;
    double m_tension_N = 0.0;
};

}  // namespace sagara::ui::console
