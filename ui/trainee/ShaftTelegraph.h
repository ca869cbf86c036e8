#pragma once

#include "core/vessel/Machinery.h"
#include "ui/trainee/Lever.h"

namespace sagara::ui::console {

/// The lever of one shaft: nine steps from full ahead down to full astern, and beside them the revolutions as
/// they are.
class ShaftTelegraph final : public Lever {
    Q_OBJECT

public:
    ShaftTelegraph(const QString& name, const core::TelegraphTable& table, QWidget* parent = nullptr);
    /// Shown, not given out: the step nearest to an ordered shaft speed.
    void setOrder(double order_rps);
    /// `drives_rps`: what the bar shows; another than the revolutions where blades turn, see
    /// core::ShaftState.
    void setShaft(double speed_rps, double drives_rps);
    /// Starts left in the bottles: one short line at the foot.
    void setNote(const QString& note);
    /// As if by hand.
    void moveTo(core::TelegraphStep step);
    void moveBy(int steps);
    core::TelegraphStep step() const { return m_step; }

Q_SIGNALS:
    void ordered(sagara::core::TelegraphStep step);

protected:
    void paintEvent(QPaintEvent*) override;
    void take(QPointF p) override;
    void stepUp(int steps) override { moveBy(steps); }

private:
    QRectF track() const;
    double yOf(double step) const;  ///< steps may have fractions
    double placeOf(double speed_rps) const;

    core::TelegraphTable m_table;
    core::TelegraphStep m_step = core::TelegraphStep::Stop;
    double m_speed_rps = 0.0;
    double m_drives_rps = 0.0;
    QString m_note;
};

/// "Half ahead".
QString telegraphStepText(core::TelegraphStep step);

}  // namespace sagara::ui::console
