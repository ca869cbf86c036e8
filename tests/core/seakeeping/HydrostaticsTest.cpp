#include "core/seakeeping/Hydrostatics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ReferenceHull.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

TEST(Hydrostatics, AreThoseOfTheReference) {
    for (const test::Row& row : test::readReference("seakeeping/hydrostatics_check.csv")) {
        const std::string name = row.text("hull") == "box_100x20x5" ? "box_barge100" : row.text("hull");
        const HullForm form = referenceHull(name);
        const Hydrostatics h = hydrostaticsOf(form);
        const double tolerance = row.text("method") == "trapezoidal rule on the stations" ? 0.01 : 0.002;
        EXPECT_NEAR(h.volume_m3, row["volume"], tolerance * row["volume"]) << name;
        EXPECT_NEAR(h.waterplane_m2, row["Aw"], tolerance * row["Aw"]) << name;
        EXPECT_NEAR(h.buoyancyHeight_m, row["KB"], tolerance * row["KB"]) << name;
        EXPECT_NEAR(h.transverseBM_m, row["BMT"], tolerance * row["BMT"]) << name;
        EXPECT_NEAR(h.longitudinalBM_m, row["BML"], tolerance * row["BML"]) << name;
        EXPECT_NEAR(h.buoyancyForward_m, row["LCB"], 0.01 * std::abs(row["LCB"]) + 1e-9) << name;
    }
}

TEST(Hydrostatics, RightingLeverOfABoxIsTheWallSidedOneUntilItsDeckIsUnder) {
    HullForm box = referenceHull("box_barge100");
    box.freeboard_m = 10.0;
    for (const RightingLever& lever : rightingLevers(box, {0.0, 0.1, 0.3, 0.45})) {
        const double t = std::tan(lever.heel_rad);
        const double wallSided = std::sin(lever.heel_rad) * (3.166667 + 0.5 * 6.666667 * t * t);
        EXPECT_NEAR(lever.gz_m, wallSided, 0.002) << lever.heel_rad;
    }
    box.freeboard_m = 1.0;
    EXPECT_LT(rightingLevers(box, {0.6}).front().gz_m, 0.8);
}

TEST(Hydrostatics, RightingLeverBeginsWithTheMetacentricHeight) {
    for (const char* name : {"s175", "kvlcc2", "dtmb5415"}) {
        const HullForm form = referenceHull(name);
        const double slope_m = rightingLevers(form, {0.01}).front().gz_m / 0.01;
        EXPECT_NEAR(slope_m, hydrostaticsOf(form).transverseGM_m, 0.001) << name;
    }
}

}  // namespace
}  // namespace sagara::core
