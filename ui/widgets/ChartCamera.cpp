#include "ui/widgets/ChartCamera.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::ui {
namespace {

constexpr double kAhead = 1.0 / 6.0;  ///< of the height: how far the ship is below the middle, head-up

double wholeDegrees_rad(double angle_rad) {
    return core::kDegree_rad * std::round(core::wrapTwoPi(angle_rad) / core::kDegree_rad);
}

}  // namespace

void ChartCamera::setSize(QSizeF size_px) {
    m_transform = m_transform.resized({std::max(1.0, size_px.width()), std::max(1.0, size_px.height())});
    apply();
}

void ChartCamera::fit(const chart::Extent& extent, double margin_px) {
    if (extent.empty) return;
    const core::NorthEast up = core::unitVector(m_transform.up_rad());
    const double c = std::abs(up.north_m), s = std::abs(up.east_m);
    const double wide_m = c * extent.width_m() + s * extent.height_m();
    const double high_m = s * extent.width_m() + c * extent.height_m();
    const QSizeF size = m_transform.size();
    const double scale = std::max(wide_m / std::max(1.0, size.width() - 2.0 * margin_px),
                                  high_m / std::max(1.0, size.height() - 2.0 * margin_px));
    m_following = false;
    m_transform = ChartTransform(size, extent.centre(), scale, m_transform.up_rad());
}

void ChartCamera::pan(QPointF by_px) {
    m_following = false;
    m_transform = m_transform.panned(by_px);
}

void ChartCamera::zoom(QPointF about, double factor) {
    const bool aboutShip = m_following && m_ship;
    m_transform = m_transform.zoomed(aboutShip ? m_transform.toScreen(m_ship->position) : about, factor);
}

void ChartCamera::centreOn(core::NorthEast p) {
    m_following = false;
    m_transform = m_transform.centredOn(p);
}

void ChartCamera::follow(bool on) {
    m_following = on;
    apply();
}

void ChartCamera::setOrientation(Orientation orientation) {
    m_orientation = orientation;
    apply();
}

void ChartCamera::setOwnShip(std::optional<Pose> ship) {
    m_ship = ship;
    apply();
}

void ChartCamera::apply() {
    const bool headUp = m_orientation == Orientation::HeadUp && m_ship;
    m_transform = m_transform.turned(headUp ? wholeDegrees_rad(m_ship->heading_rad) : 0.0);
    if (!m_following || !m_ship) return;
    const double ahead_px = headUp ? kAhead * m_transform.size().height() : 0.0;
    m_transform = m_transform.centredOn(m_ship->position + m_transform.toMetres(ahead_px) *
                                                               core::unitVector(m_transform.up_rad()));
}

}  // namespace sagara::ui
