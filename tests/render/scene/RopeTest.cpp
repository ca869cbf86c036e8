#include "render/scene/rope/Ropes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/exercise/Advance.h"
#include "core/world/Catenary.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

constexpr double kLight_Npm = 10.0, kStretch_N = 1.3e6;

TEST(Sag, ASlackLineHangsAsDeepAsItsLengthAllows) {
    // d + 8 s^2 / 3d = L: 3 m more than 30 m of span.
    EXPECT_NEAR(sag_m(30.0, 33.0, kLight_Npm, kStretch_N), std::sqrt(3.0 / 8.0 * 30.0 * 3.0), 0.02);
}

TEST(Sag, ATautLineHangsByItsWeightOverItsPull) {
    // 0.2 % of stretch: T = 2600 N, s = w d^2 / 8 T.
    const double pull_N = kStretch_N * 0.002;
    EXPECT_NEAR(sag_m(30.0, 30.0 / 1.002, kLight_Npm, kStretch_N), kLight_Npm * 900.0 / (8.0 * pull_N), 0.08);
}

TEST(Sag, GrowsWithTheLengthWithoutAJump) {
    double before = sag_m(30.0, 29.0, kLight_Npm, kStretch_N);
    for (double length_m = 29.01; length_m < 32.0; length_m += 0.01) {
        const double now = sag_m(30.0, length_m, kLight_Npm, kStretch_N);
        EXPECT_GT(now, before);
        EXPECT_LT(now - before, 0.12) << length_m;
        before = now;
    }
}

TEST(HangingCable, StartsAtTheHawseInTheDirectionOfThePullAndIsNoLongerThanItHangs) {
    const double w = 72.0, EA = 2e6;
    for (const double apart_m : {85.0, 90.0, 97.0}) {
        const core::CableShape shape = core::cableShape(apart_m, 22.0, 100.0, w, EA);
        const auto points = hangingCable(shape.horizontal_N, shape.atHawse_N, w, 22.0);
        EXPECT_NEAR(points.front().out_m, 0.0, 1e-9);
        EXPECT_NEAR(points.back().down_m, 22.0, 0.3) << apart_m;
        EXPECT_LE(points.back().out_m, apart_m + 0.5) << apart_m;
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_GT(points[i].down_m, points[i - 1].down_m - 1e-9);
            EXPECT_GE(points[i].out_m, points[i - 1].out_m);
        }
    }
}

TEST(HangingCable, IsUpAndDownWithoutAPull) {
    const auto points = hangingCable(0.0, 72.0 * 22.0, 72.0, 5.0);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1].out_m, 0.0);
    EXPECT_EQ(points[1].down_m, 5.0);
}

class Ropes : public ::testing::Test {
protected:
    const std::shared_ptr<const core::World> world = test::lessonWorld();
    core::State state = core::startState(*world, 1);

    std::vector<Rope> now() const { return ropesOf(*world, momentOf(core::view(*world, state))); }
    static double low_m(const Rope& rope) {
        double up = 1e9;
        for (const PlaceUp& p : rope.points) up = std::min(up, p.up_m);
        return up;
    }
};

TEST_F(Ropes, RunFromTheFairleadsToTheBollards) {
    const auto ropes = now();
    ASSERT_EQ(ropes.size(), 4u);
    for (std::size_t i = 0; i < ropes.size(); ++i) {
        const core::LineLayout& layout = world->ships[0]->lines[i];
        EXPECT_NEAR(core::distance(ropes[i].points.back().position, layout.bollard), 0.0, 1e-9);
        EXPECT_NEAR(ropes[i].points.back().up_m, 2.2, 0.6);  // tide
        EXPECT_NEAR(core::distance(ropes[i].points.front().position, state.ships[0].motion.position()),
                    std::hypot(layout.fairlead.x_m, layout.fairlead.y_m), 0.3);
        EXPECT_GT(ropes[i].points.front().up_m, 1.5);
        EXPECT_NEAR(ropes[i].diameter_m, 0.04, 0.001);
    }
}

TEST_F(Ropes, ALineThatIsSlackedHangsLowerAndOneThatPartsIsGone) {
    const double before = low_m(now()[0]);
    state.ships[0].lines[0].length_m += 4.0;
    EXPECT_LT(low_m(now()[0]), before - 2.0);
    state.ships[0].lines[0].status = core::LineStatus::Parted;
    EXPECT_EQ(now().size(), 3u);
    state.ships[0].lines[1].status = core::LineStatus::CastOff;
    EXPECT_EQ(now()[0].points.size(), 2u);  // into the water
}

TEST_F(Ropes, ACableHangsFromTheHawseIntoTheWaterTowardsTheAnchor) {
    core::AnchorState& anchor = state.ships[0].anchors[0];
    for (core::LineState& line : state.ships[0].lines) line.status = core::LineStatus::In;
    const core::ShipMotion& m = state.ships[0].motion;
    anchor.status = core::AnchorStatus::Running;
    anchor.cableOut_m = 2.0;
    ASSERT_EQ(now().size(), 1u);
    EXPECT_NEAR(low_m(now()[0]), 3.5 - 2.0, 0.3);  // still in the air
    anchor.status = core::AnchorStatus::Held;
    anchor.cableOut_m = 100.0;
    anchor.onBottom = true;
    anchor.position = m.position() + 118.0 * core::unitVector(m.heading_rad);
    const Rope cable = now().at(0);
    EXPECT_NEAR(low_m(cable), -1.2, 0.1);
    EXPECT_LT(core::distance(cable.points.back().position, anchor.position),
              core::distance(cable.points.front().position, anchor.position) - 2.0);
    anchor.status = core::AnchorStatus::CableParted;
    EXPECT_TRUE(now().empty());
}

TEST_F(Ropes, AreFiniteWhateverTheLinkLetsThrough) {
    for (const double far : {0.0, 1e9}) {
        for (const double length_m : {0.0, 1e4}) {
            core::OwnShipState& ship = state.ships[0];
            ship.motion.north_m = far;
            for (core::LineState& line : ship.lines) line = {core::LineStatus::Fast, length_m, far};
            for (core::AnchorState& anchor : ship.anchors) {
                anchor.status = core::AnchorStatus::Held;
                anchor.onBottom = true;
                anchor.cableOut_m = length_m;
                anchor.position = {-far, far};
            }
            for (const Rope& rope : now())
                for (const PlaceUp& p : rope.points)
                    EXPECT_TRUE(std::isfinite(p.up_m) && std::isfinite(p.position.north_m))
                        << far << length_m;
        }
    }
}

}  // namespace
}  // namespace sagara::render
