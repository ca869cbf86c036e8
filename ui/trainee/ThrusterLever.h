#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// The lever of one thruster, port to the left: a knob at the order, a bar as it pushes. Mouse wheel a tenth
/// at a time, double click stop.
class ThrusterLever final : public Gauge {
    Q_OBJECT

public:
    /// `keys` says in the tooltip how it is worked by keys; may be empty.
    ThrusterLever(const QString& name, const QString& keys, QWidget* parent = nullptr);
    /// Shown, not given out; left alone while somebody moves it. Shares of full thrust, starboard positive.
    void setOrder(double order);
    void setThrust(double share);
    /// As if by hand: whole tenths.
    void moveTo(double order);
    double order() const { return m_order; }
    bool held() const { return m_held; }

Q_SIGNALS:
    void ordered(double share);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent*) override { m_held = false; }
    void mouseDoubleClickEvent(QMouseEvent*) override { moveTo(0.0); }
    void wheelEvent(QWheelEvent* event) override;

private:
    QRectF track() const;
    double xOf(double share) const;
    void take(QPointF p);

    double m_order = 0.0;
    double m_share = 0.0;
    bool m_held = false;
};

}  // namespace sagara::ui::console
