#include <gtest/gtest.h>

#include "core/base/Angle.h"
#include "core/base/Grid.h"
#include "core/base/Shapes.h"

namespace sagara::core {
namespace {

TEST(Angle, WrapsToOneTurn) {
    EXPECT_NEAR(wrapPi(2.5 * kPi), kPi / 2, 1e-15);
    EXPECT_DOUBLE_EQ(wrapPi(-kPi), kPi);
    EXPECT_NEAR(wrapPi(350.0 * kDegree_rad), -10.0 * kDegree_rad, 1e-15);
    EXPECT_NEAR(wrapTwoPi(-0.5), kTwoPi - 0.5, 1e-15);
    EXPECT_EQ(wrapTwoPi(-1e-17), 0.0);
}

TEST(Planar, HeadingFrameTurnsForwardAndStarboard) {
    const HeadingFrame east({100.0, 200.0}, 90.0 * kDegree_rad);
    const NorthEast bow = east.point({10.0, 2.0});
    EXPECT_NEAR(bow.north_m, 98.0, 1e-12);
    EXPECT_NEAR(bow.east_m, 210.0, 1e-12);
    const BodyPoint back = east.pointInBody(bow);
    EXPECT_NEAR(back.x_m, 10.0, 1e-12);
    EXPECT_NEAR(back.y_m, 2.0, 1e-12);
}

TEST(Planar, BearingsRunClockwiseFromNorth) {
    EXPECT_DOUBLE_EQ(bearing_rad({0, 0}, {0, 5}), kPi / 2);
    EXPECT_GT(cross({1, 0}, {0, 1}), 0.0);
}

const std::vector<NorthEast> kSquare{{0, 0}, {0, 10}, {10, 10}, {10, 0}};

TEST(Shapes, ContainsKnowsInsideFromOutside) {
    EXPECT_TRUE(contains(kSquare, {5, 5}));
    EXPECT_FALSE(contains(kSquare, {5, 11}));
    EXPECT_FALSE(contains(kSquare, {-1, 5}));
}

TEST(Shapes, AreaIsSignedByTheSense) {
    EXPECT_DOUBLE_EQ(clockwiseArea_m2(kSquare), -100.0);  // south edge eastward first: anticlockwise
    EXPECT_DOUBLE_EQ(clockwiseArea_m2(std::vector<NorthEast>(kSquare.rbegin(), kSquare.rend())), 100.0);
}

TEST(Shapes, NearestPointStaysOnTheSegment) {
    const Segment s{{0, 0}, {10, 0}};
    EXPECT_EQ(nearestPoint(s, {4, 3}), (NorthEast{4, 0}));
    EXPECT_EQ(nearestPoint(s, {-4, 3}), (NorthEast{0, 0}));
    EXPECT_DOUBLE_EQ(distanceTo(s, {13, 4}), 5.0);
}

TEST(Shapes, BeyondAnEndTheNearestPointIsThatEndToTheBit) {
    // Shore tells by equality which corner is meant. a + (b - a) is not b for most numbers.
    for (int i = 0; i < 1000; ++i) {
        const Segment s{{0.1 * i, 1234.567}, {-7.3 * i, 0.001 * i}};
        const NorthEast along = s.b - s.a;
        ASSERT_EQ(nearestPoint(s, s.b + along), s.b);
        ASSERT_EQ(nearestPoint(s, s.a - along), s.a);
    }
}

TEST(Shapes, CrossingIsSeenFromBothSides) {
    const Segment gate{{0, 0}, {10, 0}};
    EXPECT_TRUE(crosses(gate, {5, -1}, {5, 1}));
    EXPECT_TRUE(crosses(gate, {5, 1}, {5, -1}));
    EXPECT_FALSE(crosses(gate, {11, -1}, {11, 1}));
    EXPECT_FALSE(crosses(gate, {5, 1}, {5, 2}));
}

TEST(Grid, BilinearIsExactForAPlaneAndHoldsTheEdgeOutside) {
    std::vector<float> values;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            values.push_back(static_cast<float>(10 + 2 * row - column));
    }
    const Grid grid({100.0, -50.0}, 5.0, 3, 4, values);
    EXPECT_DOUBLE_EQ(grid.at({106.0, -41.0}), 10.0 + 2.0 * 1.2 - 1.8);
    EXPECT_DOUBLE_EQ(grid.at({0.0, -500.0}), 10.0);
    EXPECT_TRUE(grid.covers({110.0, -35.0}));
    EXPECT_FALSE(grid.covers({110.1, -35.0}));
}

}  // namespace
}  // namespace sagara::core
