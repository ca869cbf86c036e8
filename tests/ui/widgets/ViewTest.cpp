#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "ui/widgets/ChartCamera.h"

/// Where things lie on the screen: no window is needed.
namespace sagara::ui {
namespace {

using core::NorthEast;

constexpr double kPixel_mm = 25.4 / 96.0;

TEST(ChartTransform, NorthIsUpAndEastToTheRight) {
    const ChartTransform view({800, 600}, {100.0, 50.0}, 2.0);
    EXPECT_EQ(view.toScreen({100.0, 50.0}), QPointF(400, 300));
    EXPECT_EQ(view.toScreen({120.0, 50.0}), QPointF(400, 290));
    EXPECT_EQ(view.toScreen({100.0, 70.0}), QPointF(410, 300));
}

TEST(ChartTransform, TurnedToTheEastTheNorthLiesToTheLeft) {
    const ChartTransform view({800, 600}, {}, 1.0, 0.5 * core::kPi);
    EXPECT_NEAR(view.toScreen({100.0, 0.0}).x(), 300.0, 1e-9);
    EXPECT_NEAR(view.toScreen({0.0, 100.0}).y(), 200.0, 1e-9);
}

TEST(ChartTransform, ScreenAndChartAreInverseHoweverItIsTurned) {
    for (const double up_deg : {0.0, 37.0, 180.0, 299.0}) {
        const ChartTransform view({801, 603}, {-400.0, 900.0}, 3.3, up_deg * core::kDegree_rad);
        const NorthEast p{123.0, -456.0};
        EXPECT_LT(core::distance(view.toChart(view.toScreen(p)), p), 1e-9) << up_deg;
        const chart::Extent shown = view.extent();
        for (const QPointF at : {QPointF(0, 0), QPointF(801, 0), QPointF(400, 603)}) {
            const NorthEast q = view.toChart(at);
            EXPECT_GE(q.north_m, shown.southWest.north_m - 1e-9);
            EXPECT_LE(q.east_m, shown.northEast.east_m + 1e-9);
        }
    }
}

TEST(ChartTransform, ZoomKeepsThePlaceUnderTheCursor) {
    ChartTransform view({1280, 680}, {-400.0, 900.0}, 3.3, 0.7);
    const QPointF cursor(1011, 77);
    const NorthEast place = view.toChart(cursor);
    for (const double factor : {1.25, 1.25, 0.5, 7.0, 0.01, 1e-6, 1e9}) {
        view = view.zoomed(cursor, factor);
        EXPECT_LT(core::distance(view.toChart(cursor), place), 1e-6) << factor;
    }
    EXPECT_EQ(view.metresPerPixel(), ChartTransform::kNearest_mPerPixel) << "there is an end to it";
}

TEST(ChartTransform, NaturalScaleIsLengthOnTheGroundOverLengthOnTheScreen) {
    const ChartTransform view({800, 600}, {}, 5.0);
    EXPECT_NEAR(view.denominator(kPixel_mm), 5.0 / (1e-3 * kPixel_mm), 1e-9);
}

TEST(ChartCamera, FitShowsAllOfAnExtentAndTouchesTwoSides) {
    ChartCamera camera;
    camera.setSize({1280, 680});
    chart::Extent extent;
    extent.include({-1000.0, -400.0});
    extent.include({500.0, 800.0});
    camera.fit(extent, 10.0);
    const ChartTransform view = camera.transform();
    EXPECT_NEAR(view.toScreen(extent.northEast).y(), 10.0, 1e-9);
    EXPECT_NEAR(view.toScreen(extent.southWest).y(), 670.0, 1e-9);
    EXPECT_GT(view.toScreen(extent.southWest).x(), 10.0);
}

TEST(ChartCamera, FollowingKeepsTheShipInTheMiddleThroughZooms) {
    ChartCamera camera;
    camera.setSize({1000, 600});
    camera.follow(true);
    camera.setOwnShip(ChartCamera::Pose{{1234.0, -77.0}, 0.3});
    EXPECT_EQ(camera.transform().toScreen({1234.0, -77.0}), QPointF(500, 300));
    camera.zoom({3, 3}, 2.0);
    camera.setOwnShip(ChartCamera::Pose{{1300.0, -77.0}, 0.3});
    EXPECT_EQ(camera.transform().toScreen({1300.0, -77.0}), QPointF(500, 300));
    camera.pan({50, 0});
    EXPECT_FALSE(camera.following()) << "a drag ends it";
    const NorthEast centre = camera.transform().centre();
    camera.setOwnShip(ChartCamera::Pose{{1400.0, -77.0}, 0.3});
    EXPECT_EQ(camera.transform().centre(), centre);
}

TEST(ChartCamera, HeadUpPutsTheHeadingUpAndTheShipBelowTheMiddle) {
    ChartCamera camera;
    camera.setSize({1000, 600});
    camera.setOrientation(ChartCamera::Orientation::HeadUp);
    EXPECT_EQ(camera.transform().up_rad(), 0.0) << "no ship yet";
    camera.follow(true);
    const ChartCamera::Pose ship{{0.0, 0.0}, 120.4 * core::kDegree_rad};
    camera.setOwnShip(ship);
    const QPointF at = camera.transform().toScreen(ship.position);
    EXPECT_NEAR(at.x(), 500.0, 1e-9);
    EXPECT_NEAR(at.y(), 400.0, 1e-9);
    EXPECT_NEAR(camera.transform().up_rad(), 120.0 * core::kDegree_rad, 1e-12) << "whole degrees";
    const QPointF ahead = camera.transform().toScreen(100.0 * core::unitVector(camera.transform().up_rad()));
    EXPECT_NEAR(ahead.x(), 500.0, 1e-9);
    EXPECT_LT(ahead.y(), at.y());
    camera.setOrientation(ChartCamera::Orientation::NorthUp);
    EXPECT_EQ(camera.transform().up_rad(), 0.0);
}

}  // namespace
}  // namespace sagara::ui
