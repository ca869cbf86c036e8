#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

TEST(Waterplane, ClosedFormsAgreeWithTheReferenceIntegrals) {
    const Waterplane esso{325.0, 53.0};
    const double scale = 325.0 * 53.0;  // tolerance of the file: 1e-9 of l w
    for (const test::Row& row : test::readReference("paper/closed_form_integrals.csv")) {
        const double rel = row["rel_deg"] * kDegree_rad, k = row["k"];
        const WaveIntegrals w = waveIntegrals(esso, k * std::cos(rel), k * std::sin(rel), row["phi"]);
        EXPECT_NEAR(w.integral_m2, row["integral"], 1e-9 * scale);
        EXPECT_NEAR(w.firstMomentX_m3, row["first_moment_x"], 1e-9 * scale * 325.0);
        EXPECT_NEAR(w.firstMomentY_m3, row["first_moment_y"], 1e-9 * scale * 53.0);
    }
}

TEST(Waterplane, ShapeFactorsJoinTheirSeriesSmoothly) {
    EXPECT_NEAR(shapeFactors(0.2 - 1e-9).mean, shapeFactors(0.2 + 1e-9).mean, 1e-9);
    EXPECT_NEAR(shapeFactors(0.2 - 1e-9).slope, shapeFactors(0.2 + 1e-9).slope, 1e-9);
    EXPECT_EQ(shapeFactors(0.0).mean, 1.0);
    EXPECT_EQ(shapeFactors(0.0).slope, 1.0);
    EXPECT_NEAR(shapeFactors(-0.8).slope, shapeFactors(0.8).slope, 1e-15);
}

TEST(Waterplane, EquivalentRectangleOfAFullWaterplaneIsItself) {
    Hull barge;
    barge.lengthBp_m = 100.0;
    barge.beam_m = 20.0;
    barge.waterplaneCoefficient = 1.0;
    EXPECT_NEAR(waterplaneOf(barge).length_m, 100.0, 1e-9);
    EXPECT_NEAR(waterplaneOf(barge).breadth_m, 20.0, 1e-9);
}

TEST(Springs, HeaveDecaysAtTheNaturalPeriod) {
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const ShipDynamics ship(vessel);
    ShipMotion m;
    m.down_m = 0.5;
    double crossed_s = 0.0;
    for (double t = 0.0; crossed_s == 0.0 && t < 20.0; t += 0.001) {
        m = rk4Step(m, 0.001, [&](const ShipMotion& x) { return ship.derivative(x, {}, {}, {}); });
        if (m.down_m < 0.0) crossed_s = t;
    }
    // T = 2 pi sqrt((1 + 1.1) m / (rho g Awp)) = 3.0 s; a quarter of the damped period and the lag of release
    const double stiffness = 1014.0 * kGravity_mps2 * vessel.hull.waterplaneArea_m2();
    const double natural_radps = std::sqrt(stiffness / (2.1 * vessel.hull.mass_kg())), ratio = 0.35;
    const double damped_radps = natural_radps * std::sqrt(1 - ratio * ratio);
    EXPECT_NEAR(crossed_s, (kPi / 2 + std::asin(ratio)) / damped_radps, 0.002);
}

}  // namespace
}  // namespace sagara::core
