#pragma once

#include <optional>

#include "core/exercise/World.h"
#include "render/scene/Moment.h"

namespace sagara::render {

/// Opening of a picture: tangents of the angles from the axis to its edges. An off-axis opening moves the
/// horizon up or down without tilting the axis, so channels side by side meet without a kink.
struct Lens {
    double left = -0.6;
    double right = 0.6;
    double down = -0.3;
    double up = 0.3;

    /// The given horizontal field of view, square pixels; `shift` moves the picture's middle up by that
    /// tangent.
    static Lens symmetric(double horizontalFov_rad, int width, int height, double shift = 0.0);
    /// Glasses of this magnification, from the middle of this lens's picture.
    Lens magnified(double times) const;
};

/// Where a picture is taken from. The axis lies in the mount's own deck plane, `yaw_rad` clockwise from its
/// heading; `tilt_rad` is for cameras a person turns, not for walls. Double precision all through: a place is
/// never a float before the eye's is taken from it.
struct Camera {
    core::NorthEast position;
    double up_m = 10.0;  ///< above still water
    double heading_rad = 0.0;
    double pitch_rad = 0.0;  ///< of the mount, bow up positive
    double roll_rad = 0.0;
    double yaw_rad = 0.0;
    double tilt_rad = 0.0;  ///< up is positive
    Lens lens;
    std::optional<std::size_t> inside;  ///< own ship whose wheelhouse is around the eye and is left out
};

/// Axes of a camera in frame N: unit vectors (north, east, down).
struct CameraAxes {
    std::array<double, 3> forward;
    std::array<double, 3> right;
    std::array<double, 3> up;
};
CameraAxes axesOf(const Camera& camera);

/// A point of a ship (frame B: forward, starboard, above the still water plane) in frame N, up positive.
struct PlaceUp {
    core::NorthEast position;
    double up_m;
};
PlaceUp pointOnShip(const ShipPose& pose, double x_m, double y_m, double up_m);

enum class WingSide { Port, Starboard };

Camera bridgeCamera(const core::World& world, const Moment& moment, std::size_t ship, double yaw_rad,
                    Lens lens);
/// At the ship's side abreast the bridge, where one looks along the hull.
Camera wingCamera(const core::World& world, const Moment& moment, std::size_t ship, WingSide side,
                  double yaw_rad, Lens lens);
/// Behind and above a ship, steady while she rolls.
Camera chaseCamera(const ShipPose& pose, double shipLength_m, double yaw_rad, Lens lens);
/// From a place, looking at another.
Camera shoreCamera(core::NorthEast from, double up_m, core::NorthEast at, double atUp_m, Lens lens);

}  // namespace sagara::render
