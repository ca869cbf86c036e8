#include "core/sea/Nearshore.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/sea/Dispersion.h"

namespace sagara::core {
namespace {

TEST(Nearshore, ShoalingHasItsMinimumAndGreensLaw) {
    EXPECT_NEAR(shoalingCoefficient(10.0, 200.0, 200.0), 1.0, 1e-12);
    EXPECT_NEAR(shoalingCoefficient(10.0, kDeep_m, 0.157 * 156.1), 0.913, 0.001);  // lowest, kh = 1.2
    // long waves: the height goes with the fourth root of the depth (Green 1838)
    EXPECT_NEAR(shoalingCoefficient(60.0, 4.0, 1.0), std::pow(4.0, 0.25), 0.005);
}

TEST(Nearshore, ShoalingAgreesWithTheGroupSpeedsOfTheReference) {
    // dispersion_check.csv, 10 s: 7.806549959 m/s deep, 7.523253758 m/s in 8 m
    EXPECT_NEAR(shoalingCoefficient(10.0, kDeep_m, 8.0), std::sqrt(7.806549959 / 7.523253758), 1e-3);
}

TEST(Nearshore, WavesBreakAtAShareOfTheDepthAndAtTheirSteepness) {
    EXPECT_NEAR(breakingHeight_m(20.0, 1.0), 0.6, 0.002);
    EXPECT_NEAR(breakingHeight_m(4.0, 1000.0), 0.14 * 24.98, 0.01);
    EXPECT_EQ(breakingHeight_m(8.0, 0.0), 0.0);
}

}  // namespace
}  // namespace sagara::core
