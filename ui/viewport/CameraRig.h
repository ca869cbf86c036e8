#pragma once

#include <cstdint>

#include "render/scene/Camera.h"

namespace sagara::ui {

enum class CameraKind : std::uint8_t { Bridge, WingPort, WingStarboard, Chase, Shore, Free };

/// Which camera a viewport looks through and how a person has turned it. Values only; no widget.
class CameraRig {
public:
    CameraKind kind = CameraKind::Bridge;
    std::size_t ship = 0;
    core::NorthEast shore;  ///< where the shore camera stands
    double shoreUp_m = 10.0;

    /// By a drag of the mouse; yaw to starboard, tilt upward. Tilt stays within 80 degrees.
    void turn(double yaw_rad, double tilt_rad);
    void lookAhead();  ///< as at the start, without glasses
    /// Times larger than to the naked eye, 1 to 20: from 7 on that is binoculars.
    void magnify(double times);
    double magnification() const { return m_magnification; }
    double yaw_rad() const { return m_yaw_rad; }
    double tilt_rad() const { return m_tilt_rad; }

    /// The free camera starts where the last camera was, and moves: forward along its axis, to the right and
    /// up. It stays 1 to 5000 m above still water.
    void move(double forward_m, double right_m, double up_m);

    /// Through which to draw this moment, in a picture of this size. Without an own ship, from the shore.
    render::Camera camera(const core::World& world, const render::Moment& moment, int width, int height);

private:
    render::Camera cameraOn(const core::World& world, const render::Moment& moment,
                            const render::Lens& lens) const;

    double m_yaw_rad = 0.0;
    double m_tilt_rad = 0.0;
    double m_magnification = 1.0;
    render::Camera m_last;
};

/// Field of view of a viewport across, without glasses.
inline constexpr double kViewportFov_rad = 1.0471975511965976;  // 60 degrees

/// True bearing of what a pixel of the picture shows, 0 to 2 pi, meridian convergence left to the caller.
double bearingOf_rad(const render::Camera& camera, double x_px, double y_px, int width, int height);

}  // namespace sagara::ui
