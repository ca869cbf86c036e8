#include "core/motion/Bow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// A box of Cb 0.72, 158.496 m (520 ft) long.
Hull hullOfDepth(double depth_m) {
    Hull h;
    h.lengthBp_m = 520.0 * 0.3048;
    h.beam_m = 20.0;
    h.draught_m = 8.0;
    h.depth_m = depth_m;
    h.displacement_m3 = 0.72 * h.lengthBp_m * h.beam_m * h.draught_m;
    return h;
}

TEST(Bow, TheLoadLinesAskForAHeightOfDeck) {
    const double L = hullOfDepth(0).lengthBp_m;
    const double least_m = 0.056 * L * (1.0 - L / 500.0) * 1.36 / (0.72 + 0.68);
    EXPECT_NEAR(bowOf(hullOfDepth(9.0)).freeboard_m, least_m, 1e-9);
    EXPECT_NEAR(bowOf(hullOfDepth(20.0)).freeboard_m, 12.0, 1e-9);
}

TEST(Bow, OchisThresholdIsTwelveFeetASecondForFiveHundredAndTwentyFeet) {
    EXPECT_NEAR(bowOf(hullOfDepth(12.0)).slamThreshold_mps, 12.0 * 0.3048, 0.03);
}

TEST(Bow, WaterRisesWithTheWaveTheSinkageAndTheBowThatDips) {
    ShipMotion m;
    EXPECT_DOUBLE_EQ(riseAt(m, 50.0, 1.5), 1.5);
    m.down_m = 0.5;
    EXPECT_DOUBLE_EQ(riseAt(m, 50.0, 1.5), 2.0);
    m.pitch_rad = -2.0 * kDegree_rad;  // bow down
    EXPECT_NEAR(riseAt(m, 50.0, 1.5), 2.0 + 50.0 * std::sin(2.0 * kDegree_rad), 1e-12);
}

}  // namespace
}  // namespace sagara::core
