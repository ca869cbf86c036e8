#include "core/sea/Beaufort.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Angle.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

TEST(Beaufort, BandsAndNamesAreThoseOfTheTable) {
    for (const test::Row& row : test::readReference("waves/beaufort.csv")) {
        const int number = static_cast<int>(row["B"]);
        EXPECT_EQ(beaufortName(number), row.text("name"));
        EXPECT_EQ(beaufortOfWind(row["V_min"]), number);
        EXPECT_EQ(beaufortOfWind(row["V_min"] - 0.01), std::max(number - 1, 0));
    }
}

TEST(Beaufort, SeaAtTheMiddleOfABandIsThatOfTheTable) {
    for (const test::Row& row : test::readReference("waves/beaufort.csv")) {
        const int number = static_cast<int>(row["B"]);
        if (number == 0) continue;
        const auto ocean = windSea(windOfBeaufort_mps(number), 0.0, Exposure::Ocean);
        const auto inshore = windSea(windOfBeaufort_mps(number), 0.0, Exposure::Inshore);
        ASSERT_TRUE(ocean && inshore);
        EXPECT_NEAR(ocean->significantHeight_m, row["ocean_Hs"], 1e-9) << number;
        EXPECT_NEAR(inshore->significantHeight_m, row["fetch_Hs"], 1e-9);
        EXPECT_NEAR(ocean->peakPeriod_s * 0.7718, row["ocean_T1"], 1e-9);
        EXPECT_NEAR(inshore->peakPeriod_s * 0.8344, row["fetch_T1"], 1e-9);
    }
}

TEST(Beaufort, CalmHasNoWaves) { EXPECT_FALSE(windSea(0.2, 0.0, Exposure::Ocean)); }

TEST(Beaufort, SeaGrowsWithTheWindAndRunsDownwind) {
    double before = 0.0;
    for (double wind = 0.3; wind < 35.0; wind += 0.1) {
        const auto sea = windSea(wind, kPi / 4, Exposure::Inshore);
        ASSERT_TRUE(sea);
        EXPECT_GE(sea->significantHeight_m, before);
        before = sea->significantHeight_m;
        EXPECT_NEAR(sea->wavesTo_rad, 1.25 * kPi, 1e-12);
    }
}

}  // namespace
}  // namespace sagara::core
