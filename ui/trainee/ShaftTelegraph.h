#pragma once

#include "core/vessel/Machinery.h"
#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// The lever of one shaft: nine steps from full ahead down to full astern, and beside them the revolutions as
/// they are.
class ShaftTelegraph final : public Gauge {
    Q_OBJECT

public:
    ShaftTelegraph(const QString& name, const core::TelegraphTable& table, QWidget* parent = nullptr);
    /// Shown, not given out: the step nearest to an ordered shaft speed.
    void setOrder(double order_rps);
    void setShaft(double speed_rps);
    /// Pitch, azimuth, starts left: what there is of them, one short line at the foot.
    void setNote(const QString& note);
    /// As if by hand.
    void moveTo(core::TelegraphStep step);
    void moveBy(int steps);
    core::TelegraphStep step() const { return m_step; }
    bool held() const { return m_held; }

Q_SIGNALS:
    void ordered(sagara::core::TelegraphStep step);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent*) override { m_held = false; }
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF track() const;
    double yOf(double step) const;  ///< steps may have fractions
    double placeOf(double speed_rps) const;
    void take(QPointF p);

    core::TelegraphTable m_table;
    core::TelegraphStep m_step = core::TelegraphStep::Stop;
    double m_speed_rps = 0.0;
    QString m_note;
    bool m_held = false;
};

/// "Half ahead".
QString telegraphStepText(core::TelegraphStep step);

}  // namespace sagara::ui::console
