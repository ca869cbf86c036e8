#include "ui/viewport/CameraRig.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::ui {
namespace {

constexpr double kMostTilt_rad = 80.0 * core::kDegree_rad;
constexpr double kChaseTilt_rad = 60.0 * core::kDegree_rad;

}  // namespace

void CameraRig::turn(double yaw_rad, double tilt_rad) {
    m_yaw_rad = core::wrapPi(m_yaw_rad + yaw_rad);
    m_tilt_rad = std::clamp(m_tilt_rad + tilt_rad, -kMostTilt_rad, kMostTilt_rad);
}

void CameraRig::lookAhead() {
    m_yaw_rad = m_tilt_rad = 0.0;
    m_magnification = 1.0;
}

void CameraRig::magnify(double times) { m_magnification = std::clamp(times, 1.0, 20.0); }

void CameraRig::move(double forward_m, double right_m, double up_m) {
    const double axis_rad = m_last.heading_rad + m_last.yaw_rad;
    m_last.position = m_last.position + forward_m * core::unitVector(axis_rad) +
                      right_m * core::unitVector(axis_rad + 0.5 * core::kPi);
    m_last.up_m = std::clamp(m_last.up_m + up_m, 1.0, 5000.0);
}

render::Camera CameraRig::cameraOn(const core::World& world, const render::Moment& moment,
                                   const render::Lens& lens) const {
    const std::size_t on = std::min(ship, moment.ships.empty() ? 0 : moment.ships.size() - 1);
    const bool aboard = !moment.ships.empty() && on < world.ships.size();
    switch (aboard ? kind : CameraKind::Shore) {
        case CameraKind::Bridge:
            return bridgeCamera(world, moment, on, m_yaw_rad, lens);
        case CameraKind::WingPort:
            return wingCamera(world, moment, on, render::WingSide::Port, m_yaw_rad, lens);
        case CameraKind::WingStarboard:
            return wingCamera(world, moment, on, render::WingSide::Starboard, m_yaw_rad, lens);
        case CameraKind::Chase:
            return chaseCamera(moment.ships[on], world.ships[on]->vessel.hull.lengthOverall_m, m_yaw_rad,
                               lens);
        case CameraKind::Shore: {
            const core::NorthEast at = aboard ? moment.ships[on].position : core::NorthEast{};
            render::Camera c = shoreCamera(shore, shoreUp_m, at, 5.0, lens);
            c.yaw_rad += m_yaw_rad;
            return c;
        }
        case CameraKind::Free:
            break;
    }
    // Stands level where the last camera was; the axis turns with the mouse.
    render::Camera c = m_last;
    c.pitch_rad = c.roll_rad = c.tilt_rad = 0.0;
    c.heading_rad = 0.0;
    c.yaw_rad = m_yaw_rad;
    c.inside.reset();
    c.lens = lens;
    return c;
}

render::Camera CameraRig::camera(const core::World& world, const render::Moment& moment, int width,
                                 int height) {
    const render::Lens plain =
        render::Lens::symmetric(kViewportFov_rad, std::max(1, width), std::max(1, height));
    const render::Lens lens = m_magnification > 1.0 ? plain.magnified(m_magnification) : plain;
    render::Camera c = cameraOn(world, moment, lens);
    const double most_rad = kind == CameraKind::Chase ? kChaseTilt_rad : kMostTilt_rad;
    c.tilt_rad = std::clamp(c.tilt_rad + m_tilt_rad, -most_rad, most_rad);
    return m_last = c;
}

double bearingOf_rad(const render::Camera& camera, double x_px, double y_px, int width, int height) {
    const render::CameraAxes axes = axesOf(camera);
    const render::Lens& l = camera.lens;
    const double right = l.left + (l.right - l.left) * x_px / std::max(1, width);
    const double up = l.up - (l.up - l.down) * y_px / std::max(1, height);
    const double north = axes.forward[0] + right * axes.right[0] + up * axes.up[0];
    const double east = axes.forward[1] + right * axes.right[1] + up * axes.up[1];
    const double bearing_rad = std::atan2(east, north);
    return bearing_rad < 0.0 ? bearing_rad + core::kTwoPi : bearing_rad;
}

}  // namespace sagara::ui
