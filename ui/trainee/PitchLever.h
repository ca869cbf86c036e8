#pragma once

#include "core/vessel/Machinery.h"
#include "ui/trainee/Lever.h"

namespace sagara::ui::console {

/// Pitch of the blades of one shaft over the design pitch, ahead upwards: a knob at the order, a bar as they
/// stand. It follows the telegraph until a hand moves it, and after a double click again.
class PitchLever final : public Lever {
    Q_OBJECT

public:
    PitchLever(const QString& shaft, const core::PitchControl& limits, QWidget* parent = nullptr);
    /// Shown, not given out.
    void setOrder(double pitch, bool byHand);
    void setPitch(double pitch);
    /// As if by hand: whole twentieths, kept within the limits.
    void moveTo(double pitch);
    void moveBy(int steps) { stepUp(steps); }
    /// What a lever of any make may ask of these blades.
    double within(double pitch) const;
    double order() const { return m_order; }
    bool byHand() const { return m_byHand; }

Q_SIGNALS:
    void ordered(double pitch);
    void givenBack();  ///< to the telegraph

protected:
    void paintEvent(QPaintEvent*) override;
    void take(QPointF p) override;
    void stepUp(int steps) override;
    bool rest() override;

private:
    QRectF track() const;
    double yOf(double pitch) const;

    core::PitchControl m_limits;
    double m_order = 0.0;
    double m_pitch = 0.0;
    bool m_byHand = false;
};

}  // namespace sagara::ui::console
