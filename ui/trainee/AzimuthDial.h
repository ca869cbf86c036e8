#pragma once

#include "ui/trainee/Lever.h"

namespace sagara::ui::console {

/// Where one azimuth drive pushes the ship, ahead at the top: a knob to turn at the order, an arrow as the
/// drive stands. The wheel turns the drive on top of the order, so the two may differ by the rudder angle.
class AzimuthDial final : public Lever {
    Q_OBJECT

public:
    explicit AzimuthDial(const QString& shaft, QWidget* parent = nullptr);
    /// Shown, not given out. Clockwise from ahead.
    void setOrder(double angle_rad);
    void setAngle(double angle_rad);
    /// As if by hand: whole 5 degrees.
    void turnTo(double angle_rad);
    void turnBy(int steps) { stepUp(steps); }
    double order_rad() const { return m_order_rad; }

Q_SIGNALS:
    void ordered(double angle_rad);  ///< -pi to pi

protected:
    void paintEvent(QPaintEvent*) override;
    void take(QPointF p) override;
    void stepUp(int steps) override;
    bool rest() override;

private:
    struct Circle {
        QPointF centre;
        double radius;
    };
    Circle circle() const;
    void drawScale(QPainter& painter) const;

    double m_order_rad = 0.0;
    double m_angle_rad = 0.0;
};

}  // namespace sagara::ui::console
