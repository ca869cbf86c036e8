#include "core/world/Route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Random.h"
#include "core/world/SpeedZone.h"

namespace sagara::core {
namespace {

Route routeOf(const std::vector<NorthEast>& points, double radius_m) {
    Route route;
    for (const NorthEast p : points) {
        Route::Waypoint w;
        w.position = p;
        w.turnRadius_m = radius_m;
        route.waypoints.push_back(w);
    }
    return route;
}
RoutePath pathOf(const std::vector<NorthEast>& points, double radius_m) {
    return RoutePath(routeOf(points, radius_m));
}

constexpr double kFar_m = 1e6;

/// North for 1000 m, then a right angle to starboard, 1000 m east.
RoutePath rightAngle(double radius_m = 200.0) {
    return pathOf({{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 1000.0}}, radius_m);
}

TEST(Route, AStraightLegIsMeasuredAlongAndAcross) {
    const RoutePath path = pathOf({{0.0, 0.0}, {0.0, 2000.0}}, 150.0);
    EXPECT_DOUBLE_EQ(path.length_m(), 2000.0);
    const RoutePath::Place starboard = path.nearest({-30.0, 700.0}, 700.0, kFar_m, kFar_m);
    EXPECT_DOUBLE_EQ(starboard.along_m, 700.0);
    EXPECT_NEAR(starboard.offTrack_m, 30.0, 1e-9);  // south of a track to the east
    EXPECT_EQ(starboard.leg, 1u);
    EXPECT_DOUBLE_EQ(starboard.course_rad, kPi / 2);
    EXPECT_EQ(starboard.curvature_perM, 0.0);
    EXPECT_NEAR(path.nearest({30.0, 700.0}, 700.0, kFar_m, kFar_m).offTrack_m, -30.0, 1e-9);
}

TEST(Route, ATurnIsAnArcOfItsRadiusThatTouchesBothLegs) {
    const RoutePath path = rightAngle();
    EXPECT_NEAR(path.length_m(), 800.0 + 200.0 * kPi / 2 + 800.0, 1e-9);
    EXPECT_NEAR(path.at(799.0).curvature_perM, 0.0, 1e-15);
    EXPECT_NEAR(path.at(801.0).curvature_perM, 1.0 / 200.0, 1e-15);
    const NorthEast centre{800.0, 200.0};
    for (double along_m = 800.0; along_m <= 800.0 + 100.0 * kPi; along_m += 1.0) {
        const NorthEast p = path.pointAt(along_m);
        ASSERT_NEAR(distance(p, centre), 200.0, 1e-9);
        // the course is square to the radius
        ASSERT_NEAR(wrapPi(path.at(along_m).course_rad - bearing_rad(centre, p) - kPi / 2), 0.0, 1e-9)
            << along_m;
    }
    EXPECT_NEAR(distance(path.pointAt(800.0), {800.0, 0.0}), 0.0, 1e-9);
    EXPECT_NEAR(distance(path.pointAt(800.0 + 100.0 * kPi), {1000.0, 200.0}), 0.0, 1e-9);
    EXPECT_NEAR(path.at(path.length_m()).course_rad, kPi / 2, 1e-12);
}

TEST(Route, OnAnArcTheInsideOfAStarboardTurnIsStarboard) {
    const RoutePath path = rightAngle();
    const NorthEast middle = NorthEast{800.0, 200.0} + 200.0 * unitVector(-kPi / 4);
    const double along_m = 800.0 + 50.0 * kPi;
    const RoutePath::Place inside = path.nearest(middle - 15.0 * unitVector(-kPi / 4), along_m, 300.0, 300.0);
    EXPECT_NEAR(inside.along_m, along_m, 1e-9);
    EXPECT_NEAR(inside.offTrack_m, 15.0, 1e-9);
    EXPECT_NEAR(inside.course_rad, kPi / 4, 1e-9);
    EXPECT_NEAR(path.nearest(middle + 15.0 * unitVector(-kPi / 4), along_m, 300.0, 300.0).offTrack_m, -15.0,
                1e-9);
}

TEST(Route, TheMirroredRouteHasTheMirroredTrack) {
    const std::vector<NorthEast> points{{0.0, 0.0}, {900.0, 100.0}, {1500.0, 900.0}, {2500.0, 700.0}};
    std::vector<NorthEast> mirrored = points;
    for (NorthEast& p : mirrored) p.east_m = -p.east_m;
    const RoutePath path = pathOf(points, 250.0), other = pathOf(mirrored, 250.0);
    ASSERT_NEAR(path.length_m(), other.length_m(), 1e-9);
    for (double along_m = 0.0; along_m <= path.length_m(); along_m += 37.0) {
        const NorthEast p = path.pointAt(along_m) + NorthEast{7.0, 11.0};
        const RoutePath::Place a = path.nearest(p, along_m, 200.0, 200.0);
        const RoutePath::Place b = other.nearest({p.north_m, -p.east_m}, along_m, 200.0, 200.0);
        ASSERT_NEAR(a.along_m, b.along_m, 1e-6) << along_m;
        ASSERT_NEAR(a.offTrack_m, -b.offTrack_m, 1e-6) << along_m;
        ASSERT_NEAR(a.curvature_perM, -b.curvature_perM, 1e-12) << along_m;
        ASSERT_EQ(a.leg, b.leg) << along_m;
    }
}

TEST(Route, TheLegChangesInTheMiddleOfTheTurn) {
    const RoutePath path = rightAngle();
    const double middle_m = 800.0 + 50.0 * kPi;
    EXPECT_NEAR(path.alongOf(0), 0.0, 1e-12);
    EXPECT_NEAR(path.alongOf(1), middle_m, 1e-9);
    EXPECT_NEAR(path.alongOf(2), path.length_m(), 1e-9);
    EXPECT_EQ(path.at(middle_m - 0.1).leg, 1u);
    EXPECT_EQ(path.at(middle_m + 0.1).leg, 2u);
    EXPECT_EQ(path.at(0.0).leg, 1u);
    EXPECT_EQ(path.at(path.length_m()).leg, 2u);
}

TEST(Route, WithoutARadiusTheLegsMeetAtTheWaypoint) {
    const RoutePath path = rightAngle(0.0);
    EXPECT_DOUBLE_EQ(path.length_m(), 2000.0);
    EXPECT_DOUBLE_EQ(path.alongOf(1), 1000.0);
    EXPECT_NEAR(distance(path.pointAt(1000.0), {1000.0, 0.0}), 0.0, 1e-12);
    EXPECT_EQ(path.at(999.9).leg, 1u);
    EXPECT_EQ(path.at(1000.1).leg, 2u);
    EXPECT_NEAR(path.nearest({1003.0, -4.0}, 1000.0, 100.0, 100.0).offTrack_m, -5.0,
                1e-9);  // outside of the corner
}

TEST(Route, AStraightThroughWaypointHasNoArc) {
    const RoutePath path = pathOf({{0.0, 0.0}, {500.0, 0.0}, {1500.0, 0.0}}, 200.0);
    EXPECT_DOUBLE_EQ(path.length_m(), 1500.0);
    EXPECT_DOUBLE_EQ(path.alongOf(1), 500.0);
    EXPECT_EQ(path.at(500.0).curvature_perM, 0.0);
}

TEST(Route, WhereLegsAreTooShortTheRadiusIsCutToWhatFits) {
    // Two right angles on a leg of 200 m: tangents of 300 m wanted, 100 m each given.
    const RoutePath path = pathOf({{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 200.0}, {2000.0, 200.0}}, 300.0);
    double sharpest_perM = 0.0;
    for (double along_m = 0.0; along_m < path.length_m(); along_m += 0.5) {
        sharpest_perM = std::max(sharpest_perM, std::abs(path.at(along_m).curvature_perM));
    }
    EXPECT_NEAR(1.0 / sharpest_perM, 100.0, 1e-9);
    EXPECT_NEAR(path.length_m(), 900.0 + 50.0 * kPi + 50.0 * kPi + 900.0, 1e-9);
    EXPECT_NEAR(distance(path.pointAt(path.length_m()), {2000.0, 200.0}), 0.0, 1e-9);
}

TEST(Route, AnArcWithRoomOnBothSidesKeepsItsRadiusNextToOneThatIsCut) {
    const RoutePath path =
        pathOf({{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 1000.0}, {1040.0, 1000.0}, {1040.0, 2000.0}}, 100.0);
    EXPECT_NEAR(path.at(path.alongOf(1)).curvature_perM, 0.01, 1e-12);
    EXPECT_GT(std::abs(path.at(path.alongOf(2)).curvature_perM), 0.01);
}

/// Bends of every size, all legs long enough.
RoutePath winding() {
    return pathOf({{0, 0}, {1000, 0}, {2000, 600}, {2500, 2000}, {1500, 3000}, {0, 2600}, {-600, 4000}},
                  185.0);
}

TEST(Route, PointAndCourseAreContinuousAlongThePath) {
    const RoutePath path = winding();
    const double step_m = 0.1;
    for (double along_m = step_m; along_m < path.length_m(); along_m += step_m) {
        const NorthEast before = path.pointAt(along_m - step_m), now = path.pointAt(along_m);
        ASSERT_NEAR(distance(before, now), step_m, 1e-6) << along_m;
        ASSERT_LT(std::abs(wrapPi(path.at(along_m).course_rad - path.at(along_m - step_m).course_rad)),
                  1.01 * step_m / 185.0);
    }
}

TEST(Route, NearestFindsThePlaceAPointWasMadeFrom) {
    const RoutePath path = winding();
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const double along_m = random.uniform() * path.length_m(), off_m = 300.0 * (random.uniform() - 0.5);
        const RoutePath::Place at = path.at(along_m);
        const NorthEast p = path.pointAt(along_m) + off_m * turnedRight(unitVector(at.course_rad));
        const RoutePath::Place found = path.nearest(p, along_m, 50.0, 50.0);
        ASSERT_NEAR(found.along_m, along_m, 1e-6);
        ASSERT_NEAR(found.offTrack_m, off_m, 1e-6);
        ASSERT_EQ(found.leg, at.leg);
    }
}

TEST(Route, BothEndsAreKeptTo) {
    const RoutePath path = rightAngle();
    EXPECT_EQ(path.at(-50.0).along_m, 0.0);
    EXPECT_EQ(path.pointAt(-50.0), (NorthEast{0.0, 0.0}));
    EXPECT_EQ(path.at(1e9).along_m, path.length_m());
    EXPECT_NEAR(distance(path.pointAt(1e9), {1000.0, 1000.0}), 0.0, 1e-9);
}

TEST(Route, BeforeTheStartAndBeyondTheEndOffTrackIsMeasuredFromTheLegDrawnOn) {
    const RoutePath path = rightAngle();
    const RoutePath::Place before = path.nearest({-300.0, 20.0}, 0.0, 50.0, 300.0);
    EXPECT_EQ(before.along_m, 0.0);
    EXPECT_NEAR(before.offTrack_m, 20.0, 1e-9);
    EXPECT_NEAR(path.nearest({-300.0, 0.0}, 0.0, 50.0, 300.0).offTrack_m, 0.0, 1e-9);
    const RoutePath::Place beyond = path.nearest({1015.0, 1400.0}, path.length_m(), 50.0, 300.0);
    EXPECT_EQ(beyond.along_m, path.length_m());
    EXPECT_NEAR(beyond.offTrack_m, -15.0, 1e-9);
}

TEST(Route, NearestNeverJumpsToALaterLegThatRunsPast) {
    // There and back, 40 m apart: a ship 25 m off the way out is nearer to the way back.
    const RoutePath path = pathOf({{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 40.0}, {0.0, 40.0}}, 20.0);
    double along_m = 0.0;
    for (double north_m = 0.0; north_m < 1500.0; north_m += 5.0) {
        const RoutePath::Place here = path.nearest({north_m, 25.0}, along_m, 50.0, 300.0);
        ASSERT_NEAR(here.along_m, north_m, 1e-9);
        ASSERT_NEAR(here.offTrack_m, 25.0, 1e-9);
        along_m = here.along_m;
    }
}

TEST(Route, AShipThatFollowsItIsFoundAllTheWay) {
    const RoutePath path =
        pathOf({{0.0, 0.0}, {1000.0, 0.0}, {0.0, 0.0 + 30.0}, {1000.0, 60.0}, {1000.0, 500.0}}, 100.0);
    double found_m = 0.0;
    for (double along_m = 0.0; along_m < path.length_m(); along_m += 1.0) {
        const RoutePath::Place here = path.nearest(path.pointAt(along_m), found_m, 50.0, 300.0);
        ASSERT_NEAR(here.along_m, along_m, 1.0) << along_m;
        found_m = here.along_m;
    }
}

TEST(Route, ARouteThatTurnsRightRoundStaysFinite) {
    const RoutePath path = pathOf({{0.0, 0.0}, {1000.0, 0.0}, {0.0, 0.0}}, 100.0);
    EXPECT_TRUE(std::isfinite(path.length_m()));
    for (double along_m = 0.0; along_m < path.length_m(); along_m += 0.5) {
        const NorthEast p = path.pointAt(along_m);
        ASSERT_TRUE(std::isfinite(p.north_m) && std::isfinite(p.east_m) &&
                    std::isfinite(path.at(along_m).course_rad));
        ASSERT_LT(std::abs(p.east_m), 300.0);
    }
}

TEST(SpeedZone, ALegZoneHoldsUpToItsWaypointAndACircleWithinItsRadius) {
    const std::vector<SpeedZone> zones{{3.0, false, 2, {}, 0.0}, {2.0, true, 0, {100.0, 0.0}, 50.0}};
    EXPECT_EQ(lowestSpeed_mps(zones, {0.0, 0.0}, 2, 10.0), 3.0);
    EXPECT_EQ(lowestSpeed_mps(zones, {0.0, 0.0}, 3, 10.0), 10.0);
    EXPECT_EQ(lowestSpeed_mps(zones, {50.0, 0.0}, 1, 10.0), 2.0);  // the lower of the two, on the rim
    EXPECT_EQ(lowestSpeed_mps(zones, {49.9, 0.0}, 3, 10.0), 10.0);
    EXPECT_EQ(lowestSpeed_mps(zones, {100.0, 0.0}, 3, 1.0), 1.0);  // never above what holds otherwise
}

}  // namespace
}  // namespace sagara::core
