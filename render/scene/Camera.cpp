#include "render/scene/Camera.h"

#include <cassert>
#include <cmath>

namespace sagara::render {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  ///< columns

Vector mixed(const Vector& a, double fa, const Vector& b, double fb) {
    return {a[0] * fa + b[0] * fb, a[1] * fa + b[1] * fb, a[2] * fa + b[2] * fb};
}

/// R_NB of heading, pitch, roll (in that order about z, y, x): its columns are the ship's axes in N.
Matrix rotation(double heading_rad, double pitch_rad, double roll_rad) {
    const double ch = std::cos(heading_rad), sh = std::sin(heading_rad);
    const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
    const double cr = std::cos(roll_rad), sr = std::sin(roll_rad);
    return {{{ch * cp, sh * cp, -sp},
             {ch * sp * sr - sh * cr, sh * sp * sr + ch * cr, cp * sr},
             {ch * sp * cr + sh * sr, sh * sp * cr - ch * sr, cp * cr}}};
}

}  // namespace

Lens Lens::symmetric(double horizontalFov_rad, int width, int height, double shift) {
    assert(horizontalFov_rad > 0.0 && horizontalFov_rad < 3.0 && width > 0 && height > 0);
    const double across = std::tan(0.5 * horizontalFov_rad);
    const double upward = across * height / width;
    return {-across, across, shift - upward, shift + upward};
}

Lens Lens::magnified(double times) const {
    assert(times > 0.0);
    const double halfWidth = 0.5 * (right - left) / times, halfHeight = 0.5 * (up - down) / times;
    return {-halfWidth, halfWidth, -halfHeight, halfHeight};
}

CameraAxes axesOf(const Camera& c) {
    const Matrix r = rotation(c.heading_rad, c.pitch_rad, c.roll_rad);
    const double cy = std::cos(c.yaw_rad), sy = std::sin(c.yaw_rad);
    const Vector level = mixed(r[0], cy, r[1], sy);
    const Vector right = mixed(r[0], -sy, r[1], cy);
    const Vector up{-r[2][0], -r[2][1], -r[2][2]};
    const double ct = std::cos(c.tilt_rad), st = std::sin(c.tilt_rad);
    return {mixed(level, ct, up, st), right, mixed(up, ct, level, -st)};
}

PlaceUp pointOnShip(const ShipPose& p, double x_m, double y_m, double up_m) {
    const Matrix r = rotation(p.heading_rad, p.pitch_rad, p.roll_rad);
    const Vector n = mixed(mixed(r[0], x_m, r[1], y_m), 1.0, r[2], -up_m);
    return {p.position + core::NorthEast{n[0], n[1]}, -(p.down_m + n[2])};
}

namespace {

Camera shipCamera(const ShipPose& pose, double x_m, double y_m, double up_m, double yaw_rad, Lens lens) {
    const PlaceUp place = pointOnShip(pose, x_m, y_m, up_m);
    Camera c;
    c.position = place.position;
    c.up_m = place.up_m;
    c.heading_rad = pose.heading_rad;
    c.pitch_rad = pose.pitch_rad;
    c.roll_rad = pose.roll_rad;
    c.yaw_rad = yaw_rad;
    c.lens = lens;
    return c;
}

}  // namespace

Camera bridgeCamera(const core::World& world, const Moment& moment, std::size_t ship, double yaw_rad,
                    Lens lens) {
    const core::Vessel& v = world.ships[ship]->vessel;
    Camera c =
        shipCamera(moment.ships[ship], v.bridgeEye.x_m, v.bridgeEye.y_m, v.bridgeEyeHeight_m, yaw_rad, lens);
    c.inside = ship;
    return c;
}

Camera wingCamera(const core::World& world, const Moment& moment, std::size_t ship, WingSide side,
                  double yaw_rad, Lens lens) {
    const core::Vessel& v = world.ships[ship]->vessel;
    const double out_m = 0.5 * v.hull.beam_m + 0.3;
    return shipCamera(moment.ships[ship], v.bridgeEye.x_m, side == WingSide::Port ? -out_m : out_m,
                      v.bridgeEyeHeight_m, yaw_rad, lens);
}

Camera chaseCamera(const ShipPose& pose, double shipLength_m, double yaw_rad, Lens lens) {
    Camera c;
    const double back_m = 1.5 * shipLength_m;
    c.heading_rad = pose.heading_rad + yaw_rad;
    c.position = pose.position + (-back_m) * core::unitVector(c.heading_rad);
    c.up_m = 0.35 * shipLength_m + 4.0;
    c.tilt_rad = -std::atan2(c.up_m - 3.0, back_m);
    c.lens = lens;
    return c;
}

Camera shoreCamera(core::NorthEast from, double up_m, core::NorthEast at, double atUp_m, Lens lens) {
    Camera c;
    c.position = from;
    c.up_m = up_m;
    c.heading_rad = core::bearing_rad(from, at);
    c.tilt_rad = std::atan2(atUp_m - up_m, core::distance(from, at));
    c.lens = lens;
    return c;
}

}  // namespace sagara::render
