#pragma once

#include <optional>

#include "ui/widgets/ChartTransform.h"

namespace sagara::ui {

/// CONTROLLER of what a chart shows: turns drags, zooms and the own ship's pose into a ChartTransform. Owns
/// no widget and no clock.
class ChartCamera {
public:
    enum class Orientation { NorthUp, HeadUp };
    struct Pose {
        core::NorthEast position;
        double heading_rad = 0.0;
    };

    const ChartTransform& transform() const { return m_transform; }
    Orientation orientation() const { return m_orientation; }
    bool following() const { return m_following; }

    /// Logical pixels; the middle of the chart stays in the middle.
    void setSize(QSizeF size_px);
    /// All of the extent, with so much room around it; north-up or head-up as it is. Ends following.
    void fit(const chart::Extent& extent, double margin_px);
    /// Drags the chart; ends following.
    void pan(QPointF by_px);
    /// About a point of the screen, or about the own ship while she is followed.
    void zoom(QPointF about, double factor);
    void centreOn(core::NorthEast p);
    /// Own ship in the middle, head-up a third from the bottom. Without a ship it waits for one.
    void follow(bool on);
    /// Head-up without a ship is north-up. The chart turns in steps of whole degrees, so that it is not drawn
    /// anew for every yaw.
    void setOrientation(Orientation orientation);
    void setOwnShip(std::optional<Pose> ship);

private:
    void apply();

    ChartTransform m_transform{{640.0, 480.0}, {}, 5.0};
    Orientation m_orientation = Orientation::NorthUp;
    bool m_following = false;
    std::optional<Pose> m_ship;
};

}  // namespace sagara::ui
