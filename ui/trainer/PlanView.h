#pragma once

#include <QWidget>

#include "core/bridge/OwnShip.h"
#include "ui/theme/PaletteName.h"
#include "ui/widgets/ForceArrows.h"

namespace sagara::ui {

/// VIEW: an own ship from above, bow up: pivot point, the way she moves, and what pushes her.
class PlanView final : public QWidget {
    Q_OBJECT

public:
    explicit PlanView(const core::OwnShip& ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    /// `forces` may be empty: then none are shown.
    void show(const core::ShipMotion& motion, double rudder_rad, std::vector<ShownForce> forces);
    using QWidget::show;

    QSize minimumSizeHint() const override { return {240, 210}; }
    QSize sizeHint() const override { return {320, 320}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void drawShip(QPainter& painter, double px_perM) const;
    void drawMotion(QPainter& painter, double px_perM) const;

    const core::OwnShip& m_ship;
    PaletteName m_palette = PaletteName::Day;
    core::ShipMotion m_motion;
    double m_rudder_rad = 0.0;
    std::vector<ShownForce> m_forces;
    double m_scale_NPerPx = 0.0;
};

}  // namespace sagara::ui
