#pragma once

#include "ui/trainee/Lever.h"

namespace sagara::ui::console {

/// The lever of one thruster, port to the left: a knob at the order, a bar as it pushes. Mouse wheel a tenth
/// at a time, double click stop.
class ThrusterLever final : public Lever {
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

Q_SIGNALS:
    void ordered(double share);

protected:
    void paintEvent(QPaintEvent*) override;
    void take(QPointF p) override;
    void stepUp(int steps) override;
    bool rest() override;

private:
    QRectF track() const;
    double xOf(double share) const;

    double m_order = 0.0;
    double m_share = 0.0;
};

}  // namespace sagara::ui::console
