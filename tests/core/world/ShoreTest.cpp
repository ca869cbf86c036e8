#include "core/world/Shore.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/world/Area.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

using Ring = std::vector<NorthEast>;

/// The signed distance of the nearest piece, as contact sees it.
double signedDistance_m(const Shore& shore, NorthEast p, double radius_m) {
    const Shore::Piece* nearest = nullptr;
    double nearest_m = radius_m;
    shore.near(p, radius_m, [&](const Shore::Piece& piece) {
        const double d_m = distanceTo(piece.segment, p);
        if (d_m < nearest_m) nearest_m = d_m, nearest = &piece;
    });
    return nearest ? Shore::offset(*nearest, p).distance_m : 1e9;
}

/// The whole coast of an island as one line, its first point repeated at the end.
Shore island(const Ring& ring, bool backwards = false) {
    Ring line = ring;
    line.push_back(ring.front());
    if (backwards) line = Ring(line.rbegin(), line.rend());
    return Shore({{ShoreKind::Rock, "island", line}}, {ring});
}

/// Points about a ring within `reach_m` of its box that lie on the wrong side of the shore. Those nearer than
/// `skin_m` to the line are left out.
int onTheWrongSide(const Shore& shore, const std::vector<Ring>& land, NorthEast low, NorthEast high,
                   double skin_m, int count) {
    Random random(11);
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        const NorthEast p{low.north_m + random.uniform() * (high.north_m - low.north_m),
                          low.east_m + random.uniform() * (high.east_m - low.east_m)};
        const double off_m = signedDistance_m(shore, p, 60.0);
        if (std::abs(off_m) < skin_m || off_m == 1e9) continue;
        const bool inside =
            std::any_of(land.begin(), land.end(), [&](const Ring& ring) { return contains(ring, p); });
        if (inside != (off_m < 0.0)) ++wrong;
    }
    return wrong;
}

TEST(Shore, WaterIsPositiveAndLandNegativeWhicheverWayTheLineRuns) {
    const Ring square{{0.0, 0.0}, {0.0, 40.0}, {40.0, 40.0}, {40.0, 0.0}};
    for (const bool backwards : {false, true}) {
        const Shore shore = island(square, backwards);
        EXPECT_NEAR(signedDistance_m(shore, {-3.0, 20.0}, 50.0), 3.0, 1e-12);
        EXPECT_NEAR(signedDistance_m(shore, {3.0, 20.0}, 50.0), -3.0, 1e-12);
        EXPECT_NEAR(signedDistance_m(shore, {20.0, 45.0}, 50.0), 5.0, 1e-12);
        EXPECT_NEAR(signedDistance_m(shore, {43.0, 44.0}, 50.0), 5.0, 1e-12);  // off the corner
        EXPECT_NEAR(signedDistance_m(shore, {38.0, 39.0}, 50.0), -1.0, 1e-12);
    }
}

TEST(Shore, TheNearestPointIsOnThePiece) {
    const Shore::Piece piece{{{0.0, 0.0}, {0.0, 10.0}}, 0, {1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
    EXPECT_EQ(Shore::offset(piece, {3.0, 4.0}).nearest, (NorthEast{0.0, 4.0}));
    EXPECT_EQ(Shore::offset(piece, {3.0, -4.0}).nearest, (NorthEast{0.0, 0.0}));
    EXPECT_EQ(Shore::offset(piece, {3.0, 14.0}).distance_m, 5.0);
}

TEST(Shore, AnAcuteTipOfLandHasWaterAllRound) {
    // 20 deg at the tip, which points east; turned to every direction, at coordinates that are not round
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const HeadingFrame frame({1234.567, -765.4321}, degrees * kDegree_rad);
        const Ring spit{frame.point({-10.0, 0.0}), frame.point({0.0, 56.7}), frame.point({10.0, 0.0})};
        for (const bool backwards : {false, true}) {
            const Shore shore = island(spit, backwards);
            // in the sector where the tip is the nearest point
            for (const double across_m : {-6.0, -1.0, 0.0, 1.0, 6.0}) {
                const NorthEast p = frame.point({across_m, 57.8});
                EXPECT_NEAR(signedDistance_m(shore, p, 50.0), std::hypot(across_m, 1.1), 1e-9)
                    << degrees << " " << across_m;
            }
        }
    }
}

TEST(Shore, AnAcuteInletHasLandAllRound) {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const HeadingFrame frame({-987.6543, 321.0987}, degrees * kDegree_rad);
        const Ring block{frame.point({-50.0, 0.0}), frame.point({-8.0, 0.0}), frame.point({0.0, 40.0}),
                         frame.point({8.0, 0.0}),   frame.point({50.0, 0.0}), frame.point({50.0, 80.0}),
                         frame.point({-50.0, 80.0})};
        for (const bool backwards : {false, true}) {
            const Shore shore = island(block, backwards);
            for (const double across_m : {-0.5, 0.0, 0.5}) {
                const NorthEast p = frame.point({across_m, 44.0});
                EXPECT_NEAR(signedDistance_m(shore, p, 50.0), -std::hypot(across_m, 4.0), 1e-9) << degrees;
            }
            EXPECT_GT(signedDistance_m(shore, frame.point({0.0, 35.0}), 50.0), 0.0);
        }
    }
}

TEST(Shore, SidesAgreeWithThePolygonsOfRaggedIslands) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        Ring ring;  // star-shaped, so it does not cross itself; teeth up to 10 deg sharp
        constexpr int kPoints = 24;
        for (int i = 0; i < kPoints; ++i) {
            ring.push_back((20.0 + 80.0 * random.uniform()) * unitVector(kTwoPi * i / kPoints));
        }
        EXPECT_EQ(onTheWrongSide(island(ring), {ring}, {-120.0, -120.0}, {120.0, 120.0}, 1e-6, 3000), 0)
            << seed;
        EXPECT_EQ(onTheWrongSide(island(ring, true), {ring}, {-120.0, -120.0}, {120.0, 120.0}, 1e-6, 3000), 0)
            << seed;
    }
}

TEST(Shore, LinesThatMeetAtACornerShareItsSide) {
    // an acute spit in two lines of different kinds, as a chart gives a quay that ends in a breakwater
    const Ring spit{{-10.0, 0.0}, {0.0, 60.0}, {10.0, 0.0}};
    const Shore shore(
        {{ShoreKind::Breakwater, "", {spit[0], spit[1]}}, {ShoreKind::Quay, "", {spit[1], spit[2]}}}, {spit});
    EXPECT_GT(signedDistance_m(shore, {-5.0, 61.0}, 50.0), 0.0);
    EXPECT_GT(signedDistance_m(shore, {5.0, 61.0}, 50.0), 0.0);
}

TEST(Shore, NamesAndKindsAreKept) {
    const Shore shore({{ShoreKind::Jetty, "Old jetty", {{0.0, 0.0}, {0.0, 50.0}}}}, {});
    int visits = 0;
    shore.near({1.0, 25.0}, 5.0, [&](const Shore::Piece& piece) {
        ++visits;
        EXPECT_EQ(shore.lines()[piece.line].kind, ShoreKind::Jetty);
        EXPECT_EQ(shore.lines()[piece.line].name, "Old jetty");
    });
    EXPECT_GE(visits, 1);
}

TEST(Shore, NothingNearIsMissed) {
    Random random(5);
    std::vector<ShoreLine> lines;
    for (int i = 0; i < 60; ++i) {
        const NorthEast a{2000.0 * random.uniform(), 3000.0 * random.uniform()};
        const NorthEast b = a + 150.0 * random.uniform() * unitVector(kTwoPi * random.uniform());
        lines.push_back({ShoreKind::Other, "", {a, b}});
    }
    const Shore shore(lines, {});
    for (int i = 0; i < 500; ++i) {
        const NorthEast p{3000.0 * random.uniform() - 500.0, 4000.0 * random.uniform() - 500.0};
        double least_m = 300.0;
        for (const ShoreLine& line : lines)
            least_m = std::min(least_m, distanceTo({line.points[0], line.points[1]}, p));
        EXPECT_EQ(shore.distance_m(p, 300.0), least_m);
    }
}

TEST(Shore, WithoutShoreTheLimitIsTheDistance) {
    const Shore shore;
    EXPECT_EQ(shore.distance_m({0.0, 0.0}, 123.0), 123.0);
}

TEST(Shore, SidesAgreeWithTheLandPolygonOfGalle) {
    const auto area = loadArea("galle", sagara::test::readAsset("areas/galle/area.json"));
    ASSERT_TRUE(area) << area.error().text();
    // The harbour with its breakwaters, jetties and quays closely, then the bay to a little short of the
    // chart's edge. Within 0.1 m of the line the polygon may differ: both are drawn to 1e-6 degrees.
    const NorthEast pier = area->findBerth("new-pier")->face.a;
    const NorthEast low = pier + NorthEast{-600.0, -900.0}, high = pier + NorthEast{800.0, 700.0};
    EXPECT_EQ(onTheWrongSide(area->shore, area->land, low, high, 0.1, 40'000), 0);
    EXPECT_EQ(onTheWrongSide(area->shore, area->land, {-4000.0, -4000.0}, {4000.0, 3400.0}, 0.1, 40'000), 0);
}

TEST(Shore, APointGivenTwiceChangesNothing) {
    const Ring spit{{-10.0, 0.0}, {-10.0, 0.0}, {0.0, 60.0}, {0.0, 60.0}, {10.0, 0.0}};
    for (const bool backwards : {false, true}) {
        const Shore shore = island(spit, backwards);
        for (const double north_m : {-6.0, -0.1, 0.1, 6.0}) {
            EXPECT_GT(signedDistance_m(shore, {north_m, 61.0}, 50.0), 0.0) << north_m;
        }
    }
}

TEST(ShoreKindNames, AreThoseOfTheDocuments) {
    EXPECT_STREQ(shoreKindName(ShoreKind::Quay), "quay");
    EXPECT_STREQ(shoreKindName(ShoreKind::Jetty), "jetty");
    EXPECT_STREQ(shoreKindName(ShoreKind::Breakwater), "breakwater");
    EXPECT_STREQ(shoreKindName(ShoreKind::Rock), "rock");
    EXPECT_STREQ(shoreKindName(ShoreKind::Beach), "beach");
    EXPECT_STREQ(shoreKindName(ShoreKind::Other), "shore");
}

}  // namespace
}  // namespace sagara::core
