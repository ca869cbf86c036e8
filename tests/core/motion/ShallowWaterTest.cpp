#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/Units.h"
#include "core/motion/BankLoad.h"
#include "core/motion/MmgShallow.h"
#include "core/motion/ShallowHull.h"
#include "core/motion/Squat.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Hull hullOf(double length_m, double beam_m, double draught_m, double block) {
    Hull hull;
    hull.lengthBp_m = hull.lengthOverall_m = length_m;
    hull.beam_m = beam_m;
    hull.draught_m = draught_m;
    hull.displacement_m3 = block * length_m * beam_m * draught_m;
    hull.waterDensity_kgpm3 = 1025.0;
    return hull;
}
/// Relative 1e-6, as the files' headers say, and half of the last of six digits they print.
void expectPrinted(double value, double printed, const std::string& what) {
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(printed))) - 5.0);
    EXPECT_NEAR(value, printed, 1e-6 * std::abs(printed) + 0.5 * digit) << what;
}

const Hull kTanker = hullOf(325.0, 53.0, 21.73, 0.831);

TEST(Squat, FormulasAgreeWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("environment/squat_check.csv")) {
        const SquatHull hull{row["L"], row["B"], row["T"], row["Cb"]};
        const double speed_mps = row["V_kn"] * kKnot_mps, depth_m = row["h"];
        const double width_m = row.has("W") ? row["W"] : kOpenWater_m;
        // Where gravity counts it stands as V^2/g: the table's g is 9.81.
        const double toTable = std::sqrt(kGravity_mps2 / 9.81);
        const std::string name = row.text("ship") + " " + row.text("V_kn");
        const auto expect = [&](SquatFormula formula, const char* column) {
            const bool byGravity = formula == SquatFormula::Icorels || formula == SquatFormula::Yoshimura;
            expectPrinted(squat_m(formula, hull, speed_mps * (byGravity ? toTable : 1.0), depth_m, width_m),
                          row[column], name + " " + column);
        };
        expect(SquatFormula::Barrass, "barrass_general");
        expect(SquatFormula::BarrassSimple, "barrass_simple");
        expect(SquatFormula::Icorels, "icorels");
        expect(SquatFormula::Yoshimura, "yoshimura");
    }
}

TEST(Squat, UnderWayItIsWholeInShallowWaterAndNothingInDeep) {
    const SquatHull hull{325.0, 53.0, 21.73, 0.831};
    for (int i = 0; i < 4; ++i) {
        const auto formula = static_cast<SquatFormula>(i);
        EXPECT_EQ(squatUnderWay_m(formula, hull, 5.0, 26.08), squat_m(formula, hull, 5.0, 26.08));
        EXPECT_EQ(squatUnderWay_m(formula, hull, 5.0, 120.0), 0.0);
        EXPECT_GT(squatUnderWay_m(formula, hull, 6.0, 30.0), squatUnderWay_m(formula, hull, 5.0, 30.0));
    }
}

TEST(ShallowHull, FactorsAgreeWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("environment/shallow_water_factors_check.csv")) {
        const Hull hull = hullOf(row["L"], row["B"], row["d"], row["Cb"]);
        const ShallowFactors f = shallowFactors(hull, row["h_over_d"] * row["d"]);
        expectPrinted(f.Yv, row["Yb_factor"], row.text("ship"));
        expectPrinted(f.Nv, row["Nb_factor"], row.text("ship"));
        expectPrinted(f.mx, row["mx_factor"], row.text("ship"));
        expectPrinted(f.my, row["my_factor"], row.text("ship"));
        expectPrinted(f.Jz, row["Jz_factor"], row.text("ship"));
    }
}

TEST(ShallowHull, FactorsGrowAsTheWaterGetsShallow) {
    ShallowFactors before = shallowFactors(kTanker, 20.0 * kTanker.draught_m);
    for (const double ratio : {6.0, 3.0, 2.0, 1.5, 1.2}) {
        const ShallowFactors f = shallowFactors(kTanker, ratio * kTanker.draught_m);
        EXPECT_GT(f.Yv, before.Yv);
        EXPECT_GT(f.Nv, before.Nv);
        EXPECT_GT(f.my, before.my);
        EXPECT_GT(f.resistance, before.resistance);
        before = f;
    }
}

TEST(ShallowHull, AddsNothingInDeepWaterAndOnlyResistsMore) {
    const Load drift{.surge_N = -4e5, .sway_N = -2e6, .yaw_Nm = -3e8};
    const Load both{.surge_N = -4e5, .sway_N = -2e6, .yaw_Nm = -5e8};
    EXPECT_EQ(shallowHullLoad(kTanker, both, drift, 5.0, 200.0).sway_N, 0.0);
    const double depth_m = 1.2 * kTanker.draught_m;
    const Load extra = shallowHullLoad(kTanker, both, drift, 5.0, depth_m);
    EXPECT_LT(extra.surge_N, 0.0);
    EXPECT_NEAR(extra.sway_N / drift.sway_N, 2.44103, 1e-4);  // factor of the table less one
    const double turning = shallowFactors(kTanker, depth_m).Nr - 1.0;
    EXPECT_NEAR(extra.yaw_Nm, 2.84727 * -3e8 + turning * -2e8, 1e5);
    const Load driven{.surge_N = 1e5};  // what drives her is not drag
    EXPECT_EQ(shallowHullLoad(kTanker, driven, driven, 5.0, 30.0).surge_N, 0.0);
}

TEST(Bank, LoadsAreNorrbinsAtTheReferencesPoints) {
    // bank_and_interaction.json, "check": T/h, eta, Y L/(m U^2), N/(m U^2)
    const double kPoints[][4] = {{0.0, 0.25, 0.02315, 0.00625}, {0.8, 0.25, 0.08267, 0.01833}};
    for (const auto& p : kPoints) {
        const double depth_m = p[0] > 0.0 ? kTanker.draught_m / p[0] : 1e9, U = 4.0;
        const Load load = bankLoad(kTanker, p[1], U, depth_m);
        const double mU2 = kTanker.mass_kg() * U * U;
        EXPECT_NEAR(load.sway_N * kTanker.lengthBp_m / mU2, p[2], 1e-6);
        EXPECT_NEAR(-load.yaw_Nm / mU2, p[3], 1e-6);
    }
}

TEST(Bank, BehavesAsTheReferenceAsks) {
    const double usual_m = 1.4 * kTanker.draught_m;
    const Load near = bankLoad(kTanker, 0.4, 4.0, usual_m), far = bankLoad(kTanker, 0.2, 4.0, usual_m);
    EXPECT_GT(near.sway_N, 0.0);  // to starboard, where the bank is
    EXPECT_LT(near.yaw_Nm, 0.0);  // the bow away from it
    EXPECT_GT(near.sway_N, far.sway_N);
    EXPECT_NEAR(bankLoad(kTanker, 0.4, 8.0, usual_m).sway_N / near.sway_N, 4.0, 1e-9);
    EXPECT_LT(bankLoad(kTanker, 0.4, 4.0, 2.0 * kTanker.draught_m).sway_N, near.sway_N);
    EXPECT_GT(bankLoad(kTanker, 0.4, 4.0, 1.2 * kTanker.draught_m).sway_N, near.sway_N);
    EXPECT_EQ(bankLoad(kTanker, 0.0, 4.0, usual_m).sway_N, 0.0);
    EXPECT_LT(bankLoad(kTanker, 0.4, 4.0, 1.06 * kTanker.draught_m).sway_N, 0.0);
}

}  // namespace
}  // namespace sagara::core
