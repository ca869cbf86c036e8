#include "render/scene/Camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

using core::kDegree_rad;

TEST(Camera, YawTurnsAboutTheDeckNotTheHorizon) {
    Camera c;
    c.roll_rad = 10.0 * kDegree_rad;  // heading north, starboard down
    c.yaw_rad = 90.0 * kDegree_rad;   // looking to starboard, along the sloping deck
    const CameraAxes a = axesOf(c);
    EXPECT_NEAR(a.forward[1], std::cos(c.roll_rad), 1e-12);
    EXPECT_NEAR(a.forward[2], std::sin(c.roll_rad), 1e-12);
    EXPECT_NEAR(a.right[0], -1.0, 1e-12);
}

TEST(Camera, NeighbouringChannelsShareAnEdge) {
    // The right edge of the port channel is the left edge of the middle one, at every height of the picture.
    const Lens lens = Lens::symmetric(60.0 * kDegree_rad, 1280, 720, -0.1);
    const auto ray = [&](double yaw_rad, double x, double y) {
        Camera c;
        c.pitch_rad = 0.05;
        c.roll_rad = 0.1;
        c.yaw_rad = yaw_rad;
        const CameraAxes a = axesOf(c);
        std::array<double, 3> r{};
        for (std::size_t i = 0; i < 3; ++i) r[i] = a.forward[i] + x * a.right[i] + y * a.up[i];
        const double size = std::hypot(r[0], r[1], r[2]);
        for (double& v : r) v /= size;
        return r;
    };
    for (const double y : {lens.down, 0.0, lens.up}) {
        const auto left = ray(-60.0 * kDegree_rad, lens.right, y), middle = ray(0.0, lens.left, y);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(left[i], middle[i], 1e-12);
    }
}

TEST(Camera, ShiftMovesTheHorizonAndKeepsTheSize) {
    const Lens plain = Lens::symmetric(1.0, 1000, 500), shifted = Lens::symmetric(1.0, 1000, 500, -0.1);
    EXPECT_NEAR(shifted.up - shifted.down, plain.up - plain.down, 1e-12);
    EXPECT_NEAR(0.5 * (shifted.up + shifted.down), -0.1, 1e-12);
    EXPECT_NEAR(plain.magnified(7.0).right, plain.right / 7.0, 1e-12);
}

TEST(Camera, APointOfAShipMovesWithHer) {
    ShipPose pose;
    pose.position = {100.0, 200.0};
    pose.heading_rad = 90.0 * kDegree_rad;
    pose.pitch_rad = 2.0 * kDegree_rad;
    pose.down_m = 0.5;
    const PlaceUp bow = pointOnShip(pose, 25.0, 0.0, 3.0);
    EXPECT_NEAR(bow.position.east_m, 200.0 + 25.0 * std::cos(pose.pitch_rad) - 3.0 * std::sin(pose.pitch_rad),
                1e-9);
    EXPECT_NEAR(bow.position.north_m, 100.0, 1e-9);
    EXPECT_NEAR(bow.up_m, -0.5 + 25.0 * std::sin(pose.pitch_rad) + 3.0 * std::cos(pose.pitch_rad), 1e-9);
}

}  // namespace
}  // namespace sagara::render
