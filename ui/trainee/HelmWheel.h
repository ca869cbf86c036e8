#pragma once

#include "ui/trainee/Lever.h"

namespace sagara::ui::console {

/// The wheel: an arc of rudder orders with a knob to drag, a needle at the rudder as it is. Mouse wheel a
/// degree at a time, double click midships.
class HelmWheel final : public Lever {
    Q_OBJECT

public:
    explicit HelmWheel(double limit_rad, QWidget* parent = nullptr);
    /// Shown, not given out; left alone while somebody turns it.
    void setOrder(double order_rad);
    void setRudder(double angle_rad);
    /// As if by hand: whole degrees, kept within the limit.
    void turnTo(double order_rad);
    double order_rad() const { return m_order_rad; }

Q_SIGNALS:
    void ordered(double rudder_rad);

protected:
    void paintEvent(QPaintEvent*) override;
    void take(QPointF p) override;
    void stepUp(int steps) override;
    bool rest() override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Arc {
        QPointF centre;
        double radius;
    };
    Arc arc() const;
    QPointF at(double rudder_rad, double radius) const;
    double rudderAt(QPointF p) const;

    double m_limit_rad;
    double m_order_rad = 0.0;
    double m_rudder_rad = 0.0;
};

}  // namespace sagara::ui::console
