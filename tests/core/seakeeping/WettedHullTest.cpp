#include "core/seakeeping/WettedHull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "ReferenceHull.h"
#include "core/base/Units.h"
#include "core/sea/Dispersion.h"
#include "core/seakeeping/Hydrostatics.h"
#include "core/seakeeping/SeakeepingTables.h"
#include "core/seakeeping/StripTheory.h"

namespace sagara::core {
namespace {

Six inCalmWater(const WettedHull& hull, const HullAttitude& at) {
    const ActiveWaves calm{};
    return hull.correction(calm, at, 1.0);
}

TEST(WettedHull, AddsNothingToTheHullAtRest) {
    const Six more = inCalmWater(WettedHull(referenceHull("dtmb5415")), {});
    for (const double value : more) EXPECT_NEAR(value, 0.0, 1.0);
}

/// Wall-sided: GZ = (GM + 1/2 BM tan^2 heel) sin heel, with the volume as it is (the box keeps her level).
TEST(WettedHull, RightsAHeeledBoxByTheWallSidedFormula) {
    const HullForm form = referenceHull("box_barge100");
    const WettedHull hull(form);
    const Hydrostatics h = hydrostaticsOf(form);
    const double weight_N = form.mass_kg * kGravity_mps2;
    for (const double heel_deg : {5.0, 10.0, 15.0}) {
        const double heel_rad = heel_deg * kDegree_rad, t = std::tan(heel_rad);
        const double GM_m = h.buoyancyHeight_m + h.transverseBM_m - form.gravityHeight_m;
        const double GZ_m = (GM_m + 0.5 * h.transverseBM_m * t * t) * std::sin(heel_rad);
        const double linear_Nm = restoringMatrix(form)(3, 3) * heel_rad;
        HullAttitude at;
        at.roll_rad = heel_rad;
        const double righting_Nm = linear_Nm - inCalmWater(hull, at)[3];
        EXPECT_NEAR(righting_Nm / weight_N, GZ_m, 0.01 * GZ_m) << heel_deg;
    }
}

TEST(WettedHull, IsNothingToSpeakOfWhereMotionsAreSmall) {
    const HullForm form = referenceHull("dtmb5415");
    const WettedHull hull(form);
    HullAttitude at;
    at.down_m = 0.05;
    at.pitch_rad = 0.001;
    const Matrix6 C = restoringMatrix(form);
    EXPECT_LT(std::abs(inCalmWater(hull, at)[2]), 0.02 * C(2, 2) * at.down_m);
    EXPECT_LT(std::abs(inCalmWater(hull, at)[4]), 0.02 * C(4, 4) * at.pitch_rad);
}

/// A flared bow that goes in deep is pushed up by more, one that comes out by less, than by its waterplane.
TEST(WettedHull, FlareHoldsTheBowUp) {
    const WettedHull hull(referenceHull("dtmb5415"));
    HullAttitude bowDown, bowUp;
    bowDown.pitch_rad = -0.05;
    bowUp.pitch_rad = 0.05;
    EXPECT_LT(inCalmWater(hull, bowDown)[2], 0.0);  // up
    EXPECT_LT(inCalmWater(hull, bowUp)[2], 0.0);
}

/// In a long wave she lies on its slope: as wetted as at rest.
TEST(WettedHull, AHullThatRidesALongWaveIsAsWettedAsAtRest) {
    const HullForm form = referenceHull("dtmb5415");
    const WettedHull hull(form);
    const double omega = 0.05, amplitude_m = 3.0, k = omega * omega / kGravity_mps2;
    const WaveTable table = WaveTable::regular(omega, 0.0, kDeep_m);
    const SeaState sea{{}, {0}, {amplitude_m}};
    auto waves = std::make_unique<ActiveWaves>();
    activeWaves(table, sea, SimTime{}, *waves);
    HullAttitude at;
    at.heading_rad = 0.5 * kPi;  // waves towards her port side
    const double phase = waves->phase_rad[0];
    at.down_m = -amplitude_m * std::cos(phase);
    at.roll_rad = -k * amplitude_m * std::sin(phase);
    const double weight_N = form.mass_kg * kGravity_mps2;
    const Six more = hull.correction(*waves, at, 1.0);
    EXPECT_NEAR(more[2] / weight_N, 0.0, 1e-3);
    EXPECT_NEAR(more[3] / (weight_N * form.breadth_m), 0.0, 1e-4);
}

}  // namespace
}  // namespace sagara::core
