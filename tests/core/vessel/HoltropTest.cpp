#include "core/vessel/Holtrop.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// The worked example of Holtrop and Mennen (1982).
HoltropHull example() {
    HoltropHull h{};
    h.length_m = 205.0;
    h.beam_m = 32.0;
    h.draught_m = 10.0;
    h.volume_m3 = 37500.0;
    h.waterplane = 0.75;
    h.midship = 0.98;
    h.buoyancy_pct = -0.75;
    h.bulb_m2 = 20.0;
    h.bulbHeight_m = 4.0;
    h.transom_m2 = 16.0;
    h.sternForm = 10.0;
    h.appendages_m2 = 50.0;
    return h;
}

TEST(Holtrop, GivesTheWorkedExample) {
    const HoltropResistance r = holtropResistance(example(), 25.0 * kKnot_mps, 1025.0, 1.18831e-6);
    EXPECT_NEAR(r.wetted_m2, 7381.45, 0.05);
    EXPECT_NEAR(1e-3 * r.friction_N, 869.63, 0.1);
    EXPECT_NEAR(1e-3 * r.appendages_N, 8.83, 0.05);
    EXPECT_NEAR(1e-3 * r.bulb_N, 0.049, 0.001);
    EXPECT_EQ(r.transom_N, 0.0);
    EXPECT_NEAR(1e-3 * r.allowance_N, 221.98, 0.3);
    // Newer terms than the example's (1984): hump of the waves and form factor, 1.156 then.
    EXPECT_NEAR(1e-3 * r.waves_N, 557.11, 0.02 * 557.11);
    EXPECT_NEAR(r.formFactor, 1.156, 0.04);
    EXPECT_NEAR(1e-3 * r.total_N(), 1793.26, 0.03 * 1793.26);
}

TEST(Holtrop, ResistanceGrowsWithSpeedThroughAllItsRanges) {
    double before_N = 0.0;
    for (double speed_mps = 2.0; speed_mps < 30.0; speed_mps += 0.5) {
        const double now_N = holtropResistance(example(), speed_mps, 1025.0, 1.19e-6).total_N();
        EXPECT_GT(now_N, before_N) << speed_mps;
        before_N = now_N;
    }
}

TEST(Holtrop, KnowsWhichShipsItWasMadeOf) {
    EXPECT_TRUE(holtropHolds(example(), 25.0 * kKnot_mps));
    EXPECT_FALSE(holtropHolds(example(), 45.0 * kKnot_mps));
    HoltropHull tug = example();
    tug.length_m = 90.0;
    EXPECT_FALSE(holtropHolds(tug, 5.0));
}

}  // namespace
}  // namespace sagara::core
