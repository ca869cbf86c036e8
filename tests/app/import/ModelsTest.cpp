#include <gtest/gtest.h>

#include <cmath>

#include "app/import/BerthPlan.h"
#include "app/import/FrontMarch.h"
#include "app/import/ShelterModel.h"
#include "core/base/Grid.h"
#include "core/base/Units.h"

namespace sagara::importer {
namespace {

using core::NorthEast;

constexpr Raster kSquare{{-500.0, -500.0}, 10.0, 101, 101};

TEST(Raster, NodesInsideARingAreThoseThePolygonContains) {
    const Ring ring{{-300.0, -250.0}, {410.0, -330.0}, {120.0, 40.0}, {380.0, 290.0}, {-222.0, 333.0}};
    const std::vector<char> inside = nodesInside(kSquare, {ring});
    for (std::size_t i = 0; i < inside.size(); ++i) {
        EXPECT_EQ(inside[i] != 0, core::contains(ring, kSquare.node(i))) << i;
    }
}

TEST(Raster, LiesInsideItsBox) {
    const core::LocalFrame frame({6.0, 80.0});
    const Raster r = rasterInside({{5.98, 79.97, 6.01, 80.02}, 20.0}, frame);
    for (const std::size_t i : {std::size_t{0}, r.columns - 1, r.size() - r.columns, r.size() - 1}) {
        const core::GeoPoint p = frame.toGeo(r.node(i));
        EXPECT_TRUE((GeoBox{5.98, 79.97, 6.01, 80.02}.contains(p))) << i;
    }
}

TEST(FrontMarch, AStraightFrontComesOutExactly) {
    const NorthEast along = core::unitVector(30.0 * core::kDegree_rad);
    std::vector<double> seeds(kSquare.size(), kUnreached_m);
    for (std::size_t i = 0; i < kSquare.columns; ++i) seeds[i] = dot(kSquare.node(i), along);
    for (std::size_t i = 0; i < kSquare.size(); i += kSquare.columns) seeds[i] = dot(kSquare.node(i), along);
    const std::vector<double> ways = marchFront(kSquare, std::vector<char>(kSquare.size(), 0), seeds);
    for (std::size_t i = 0; i < ways.size(); ++i) EXPECT_NEAR(ways[i], dot(kSquare.node(i), along), 1e-9);
}

TEST(FrontMarch, NothingPassesAClosedWall) {
    std::vector<char> blocked(kSquare.size(), 0);
    for (std::size_t i = 0; i < kSquare.rows; ++i) blocked[i * kSquare.columns + i] = 1;  // a diagonal one
    std::vector<double> seeds(kSquare.size(), kUnreached_m);
    seeds[kSquare.columns - 1] = 0.0;  // south-east corner
    const std::vector<double> ways = marchFront(kSquare, blocked, seeds);
    EXPECT_EQ(ways[kSquare.size() - kSquare.columns], kUnreached_m);  // north-west corner
    EXPECT_NEAR(ways[kSquare.columns - 3], 20.0, 1e-9);
}

/// A breakwater from the west to the middle, waves from the south.
LocalCoast breakwater() {
    LocalCoast coast;
    coast.land = {{{-10.0, -2000.0}, {10.0, -2000.0}, {10.0, 0.0}, {-10.0, 0.0}}};
    std::vector<NorthEast> line = coast.land[0];
    line.push_back(line[0]);
    coast.shore = core::Shore({{core::ShoreKind::Breakwater, "", line}}, coast.land);
    return coast;
}

/// Deep in the shadow the incident term of Sommerfeld's half plane: K^2 = L / (16 pi^2 r sin^2(a/2)). 20 %:
/// the front march is first order, and the formula here has the 1 that keeps it below one.
TEST(ShelterModel, BehindASemiInfiniteBreakwaterIsPenneyAndPrice) {
    ShelterRules rules;
    rules.waveLength_m = 100.0;
    rules.sectors = {{180.0, 180.0, 1.0}};
    const Raster raster{{-800.0, -800.0}, 10.0, 161, 161};
    const std::vector<double> factors = modelShelter(rules, {raster}, breakwater())[0];
    const core::Grid grid(raster.southWest, raster.spacing_m, raster.rows, raster.columns,
                          std::vector<float>(factors.begin(), factors.end()));
    for (const double turn_deg : {40.0, 60.0, 80.0}) {
        for (const double r_m : {300.0, 500.0, 700.0}) {
            const double half = std::sin(0.5 * turn_deg * core::kDegree_rad);
            const double expected = std::sqrt(100.0 / (16.0 * core::kPi * core::kPi * r_m * half * half));
            const NorthEast p = NorthEast{10.0, 0.0} + r_m * core::unitVector(-turn_deg * core::kDegree_rad);
            EXPECT_NEAR(grid.at(p), expected, 0.2 * expected) << turn_deg << " deg, " << r_m << " m";
        }
    }
    EXPECT_NEAR(grid.at({500.0, 300.0}), 1.0, 1e-6);
    EXPECT_NEAR(grid.at({-300.0, -300.0}), 1.0, 1e-6);
}

/// No step where one grid takes over from the other. 0.03 where waves leave the fine grid: it knows its way
/// better.
TEST(ShelterModel, AFineGridBeginsWithTheFactorsOfTheCoarseOne) {
    ShelterRules rules;
    rules.sectors = {{150.0, 210.0, 1.0}};
    const Raster coarse{{-800.0, -800.0}, 20.0, 81, 81}, fine{{-200.0, -400.0}, 10.0, 71, 71};
    const auto factors = modelShelter(rules, {fine, coarse}, breakwater());
    for (std::size_t i = 0; i < fine.rows; i += 2) {
        const std::size_t onCoarse = (30 + i / 2) * coarse.columns + 20;
        if (std::abs(fine.node(i, 0).north_m) <= 50.0) continue;  // the breakwater crosses there
        EXPECT_NEAR(factors[0][i * fine.columns], factors[1][onCoarse], 0.01);
        EXPECT_NEAR(factors[0][i * fine.columns + 70], factors[1][onCoarse + 35], 0.03);
    }
}

TEST(BerthPlan, BollardsAndFendersStandEvenlyAlongTheFace) {
    const core::LocalFrame frame({6.0, 80.0});
    BerthRules rules;
    rules.a = frame.toGeo({0.0, 100.0});
    rules.b = frame.toGeo({0.0, 0.0});  // runs west: the water is to the north
    rules.bollardPrefix = std::string("test");
    rules.numberedFromB = true;
    rules.bollardSpacing_m = 20.0;
    rules.bollardSetback_m = 0.8;
    rules.fenderSpacing_m = 30.0;
    const BerthPlan plan = planBerth(rules, frame);
    ASSERT_EQ(plan.bollards.size(), 5u);
    EXPECT_EQ(plan.bollards[0].id, "test-01");
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(plan.bollards[i].position.east_m, 10.0 + 20.0 * static_cast<double>(i), 1e-6);
        EXPECT_NEAR(plan.bollards[i].position.north_m, -0.8, 1e-6);
    }
    ASSERT_EQ(plan.fenders.size(), 3u);
    EXPECT_NEAR(plan.fenders[0].east_m, 80.0, 1e-6);
    EXPECT_NEAR(plan.fenders[2].east_m, 20.0, 1e-6);
}

}  // namespace
}  // namespace sagara::importer
