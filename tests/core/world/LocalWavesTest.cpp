#include "core/world/LocalWaves.h"

#include <gtest/gtest.h>

#include "core/sea/Nearshore.h"

namespace sagara::core {
namespace {

/// 40 m deep in the south, dry 1000 m further north; half the height behind 500 m north.
Area beach(bool shoaling) {
    Area a;
    a.waveDepth_m = 40.0;
    a.shoaling = shoaling;
    a.depths.emplace_back(NorthEast{0.0, -1000.0}, 1000.0, 2, 3, std::vector<float>{40, 40, 40, 0, 0, 0});
    a.shelter.emplace_back(NorthEast{0.0, -500.0}, 500.0, 3, 3,
                           std::vector<float>{1, 1, 1, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F});
    return a;
}

SeaSystem swell(double height_m, double period_s) {
    SeaSystem s;
    s.significantHeight_m = height_m;
    s.peakPeriod_s = period_s;
    return s;
}

TEST(LocalWaves, AreThoseOfTheShelterWhereTheAreaDoesNotShoal) {
    const Area area = beach(false);
    const LocalWaves waves(area, {swell(3.0, 9.0)}, 0.0);
    EXPECT_EQ(waves.factorAt({0.0, 0.0}), 1.0);
    EXPECT_EQ(waves.factorAt({750.0, 0.0}), 0.5);
}

TEST(LocalWaves, TakeTheHeightOfAllSystemsAndThePeriodOfTheHighest) {
    const Area area = beach(true);
    const LocalWaves waves(area, {swell(0.9, 5.0), swell(1.2, 11.0)}, 0.0);
    EXPECT_DOUBLE_EQ(waves.significantHeight_m(), 1.5);
    EXPECT_EQ(waves.peakPeriod_s(), 11.0);
}

TEST(LocalWaves, ShoalAndBreakByTheDepthOfTheTide) {
    const Area area = beach(true);
    const LocalWaves low(area, {swell(4.0, 9.0)}, 0.0), high(area, {swell(4.0, 9.0)}, 2.0);
    EXPECT_NEAR(low.factorAt({0.0, 0.0}), 1.0, 1e-9);  // where the area's waves were taken: nothing
    for (double north_m = 0.0; north_m <= 1000.0; north_m += 20.0) {
        const NorthEast p{north_m, 0.0};
        const double depth_m = area.depth_m(p), factor = low.factorAt(p);
        EXPECT_LE(4.0 * factor, 0.6 * depth_m + 1e-9) << north_m;
        EXPECT_LE(factor, area.shelterFactor(p) * shoalingCoefficient(9.0, 40.0, depth_m) + 1e-12);
        EXPECT_DOUBLE_EQ(factor, low.factor(area.shelterFactor(p), low.ofDepth(depth_m)));
    }
    EXPECT_EQ(low.factorAt({1000.0, 0.0}), 0.0);
    EXPECT_GT(high.factorAt({1000.0, 0.0}), 0.2);
    EXPECT_LE(LocalWaves(area, {swell(0.01, 25.0)}, 0.0).factorAt({998.0, 0.0}), LocalWaves::kMostFactor);
}

TEST(LocalWaves, OfACalmSeaNothingBreaks) {
    const Area area = beach(true);
    EXPECT_EQ(LocalWaves(area, {}, 0.0).factorAt({0.0, 0.0}), 1.0);
}

}  // namespace
}  // namespace sagara::core
