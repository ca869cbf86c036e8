#include "ui/viewport/CameraRig.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/exercise/Snapshot.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::ui {
namespace {

class Rig : public ::testing::Test {
protected:
    std::shared_ptr<const core::World> m_world = test::lessonWorld();
    render::Moment m_moment = render::momentOf(core::view(*m_world, core::startState(*m_world, 3)));
    CameraRig m_rig;

    render::Camera camera(int width = 640, int height = 360) {
        return m_rig.camera(*m_world, m_moment, width, height);
    }
};

TEST_F(Rig, TheBridgeCameraLooksAheadFromTheBridge) {
    const render::Camera c = camera();
    EXPECT_EQ(c.inside, std::optional<std::size_t>(0));
    EXPECT_NEAR(c.heading_rad + c.yaw_rad, m_moment.ships[0].heading_rad, 1e-12);
    EXPECT_NEAR(c.lens.right, std::tan(core::kPi / 6.0), 1e-9);
}

TEST_F(Rig, TurnsAndComesBack) {
    m_rig.turn(0.5, 0.1);
    EXPECT_NEAR(camera().yaw_rad, 0.5, 1e-12);
    m_rig.turn(0.0, 5.0);
    EXPECT_NEAR(m_rig.tilt_rad(), 80.0 * core::kDegree_rad, 1e-12);
    m_rig.lookAhead();
    EXPECT_EQ(camera().yaw_rad, 0.0);
}

TEST_F(Rig, GlassesNarrowTheView) {
    const double plain = camera().lens.right;
    m_rig.magnify(7.0);
    EXPECT_NEAR(camera().lens.right, plain / 7.0, 1e-9);
    m_rig.magnify(1000.0);
    EXPECT_EQ(m_rig.magnification(), 20.0);
}

TEST_F(Rig, TheFreeCameraStartsWhereTheLastWasAndMoves) {
    const render::Camera bridge = camera();
    m_rig.kind = CameraKind::Free;
    const render::Camera start = camera();
    EXPECT_EQ(start.position.north_m, bridge.position.north_m);
    EXPECT_EQ(start.inside, std::nullopt);
    m_rig.move(0.0, 0.0, 20.0);
    m_rig.move(100.0, 0.0, 0.0);  // yaw 0: north
    const render::Camera moved = camera();
    EXPECT_NEAR(moved.up_m, start.up_m + 20.0, 1e-9);
    EXPECT_NEAR(moved.position.north_m, start.position.north_m + 100.0, 1e-9);
    m_rig.move(0.0, 0.0, -1e6);
    EXPECT_EQ(camera().up_m, 1.0);
}

TEST_F(Rig, EveryKindGivesACameraAboveTheWater) {
    for (const auto kind : {CameraKind::Bridge, CameraKind::WingPort, CameraKind::WingStarboard,
                            CameraKind::Chase, CameraKind::Shore, CameraKind::Free}) {
        m_rig.kind = kind;
        const render::Camera c = camera();
        EXPECT_GT(c.up_m, 1.0) << static_cast<int>(kind);
        EXPECT_LT(c.lens.left, 0.0);
    }
}

TEST_F(Rig, WithoutAnOwnShipItLooksFromTheShore) {
    m_moment.ships.clear();
    m_rig.shore = {300.0, 400.0};
    EXPECT_EQ(camera().position.east_m, 400.0);
}

TEST_F(Rig, ThePixelInTheMiddleBearsAlongTheAxis) {
    const render::Camera c = camera();
    const double axis_rad = c.heading_rad + c.yaw_rad;
    EXPECT_NEAR(core::wrapPi(bearingOf_rad(c, 320, 180, 640, 360) - axis_rad), 0.0, 1e-3);
    EXPECT_NEAR(core::wrapPi(bearingOf_rad(c, 640, 180, 640, 360) - axis_rad), core::kPi / 6.0, 1e-3);
}

}  // namespace
}  // namespace sagara::ui
