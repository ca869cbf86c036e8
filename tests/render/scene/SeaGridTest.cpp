#include "render/scene/sea/SeaGrid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/scene/sea/Foam.h"

namespace sagara::render {
namespace {

TEST(SeaGrid, RingsGrowAllTheWayOut) {
    for (double t = 0.01; t <= 1.0; t += 0.01) EXPECT_GT(seaRing_m(t), seaRing_m(t - 0.01));
    EXPECT_DOUBLE_EQ(seaRing_m(1.0), kSeaReach_m);
}

TEST(SeaGrid, NeighbouringSectorsShareTheirEdge) {
    const SeaGrid grid = seaSector(10, 4);
    // The last column turned back by a sector is the first.
    for (std::size_t ring = 0; ring <= 10; ++ring) {
        const float* first = &grid.vertices[5 * (ring * 5)];
        const float* last = &grid.vertices[5 * (ring * 5 + 4)];
        const double turn = 2.0 * 3.14159265358979323846 / kSeaSectors;
        const double east = static_cast<double>(first[0]), south = static_cast<double>(first[2]);
        EXPECT_NEAR(static_cast<double>(last[0]), east * std::cos(turn) - south * std::sin(turn), 1e-6);
        EXPECT_NEAR(static_cast<double>(last[2]), east * std::sin(turn) + south * std::cos(turn), 1e-6);
        EXPECT_EQ(first[3], last[3]);
    }
}

TEST(Foam, SoMuchOfAGaussianSeaBreaksAsMonahanSaw) {
    for (const double wind : {6.0, 9.3, 15.0, 20.0}) {
        const double above = 0.5 * std::erfc(breakingAcceleration(wind) / std::sqrt(2.0));
        EXPECT_NEAR(above / whiteCapShare(wind), 1.0, 0.02) << wind;  // error of the approximation
    }
}

}  // namespace
}  // namespace sagara::render
