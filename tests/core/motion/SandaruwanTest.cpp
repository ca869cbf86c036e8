#include <gtest/gtest.h>

#include "core/base/Angle.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Vessel essoOsaka() {
    return loadVessel("esso-osaka.json", test::readAsset("vessels/esso-osaka.json")).value();
}

SandaruwanModel paperModel(const Vessel& vessel) {
    return std::get<SandaruwanModel>(vessel.model("sandaruwan2010").value()->parameters);
}

TEST(Sandaruwan, CorrectedModelReproducesTheReferenceTurn) {
    Vessel vessel = essoOsaka();
    SandaruwanModel model = paperModel(vessel);
    model.scalesWithSpeed = false;  // the reference keeps K and tau of the first speed
    vessel.hull.displacement_m3 = 3.194e8 / vessel.hull.waterDensity_kgpm3;
    const TransferShip ship(model, vessel);
    const Load thrust{.surge_N = 1.14381e6};  // constant in the reference
    ShipMotion m;
    m.surge_mps = 5.1444;
    double time_s = 0.0;
    for (const test::Row& row : test::readReference("paper/corrected_model_turn_p35.csv")) {
        for (; time_s < row["t"] - 0.01; time_s += 0.02) {
            m = rk4Step(m, 0.02, [&](const ShipMotion& x) {
                const PlanarAcceleration a = ship.acceleration(x, {35.0 * kDegree_rad, {}}, thrust);
                ShipMotion rate;
                rate.north_m = x.surge_mps * std::cos(x.heading_rad) - x.sway_mps * std::sin(x.heading_rad);
                rate.east_m = x.surge_mps * std::sin(x.heading_rad) + x.sway_mps * std::cos(x.heading_rad);
                rate.heading_rad = x.yawRate_radps;
                rate.surge_mps = a.surge_mps2;
                rate.sway_mps = a.sway_mps2;
                rate.yawRate_radps = a.yaw_radps2;
                return rate;
            });
        }
        // tolerance of the file: 0.05 % of L, 0.05 deg
        ASSERT_LE(distance(m.position(), {row["x"], row["y"]}), 0.0005 * 325.0) << row["t"];
        ASSERT_NEAR(m.heading_rad / kDegree_rad, row["psi"], 0.05) << row["t"];
        ASSERT_NEAR(m.surge_mps, row["u"], 1e-3);
        ASSERT_NEAR(m.sway_mps, row["v"], 1e-3);
    }
}

TEST(Sandaruwan, ThrustAt51RpmAnd10KnotsIsTheAuditsNotThePapers) {
    const Vessel vessel = essoOsaka();
    const TransferShip ship(paperModel(vessel), vessel);
    ShipMotion m;
    m.surge_mps = 5.1444;
    const double balance =
        ship.acceleration(m, {0.0, {51.0 / 60.0}}, {}).surge_mps2 * 3.354e8;  // N, of 1.14 MN
    EXPECT_NEAR(balance, 0.0, 0.01 * 1.144e6);
}

TEST(Sandaruwan, StartsFromRestAndKeepsStillWithoutThrust) {
    const Vessel vessel = essoOsaka();
    const ShipDynamics ship(vessel, "sandaruwan2010");
    ShipMotion m;
    for (int i = 0; i < 50 * 600; ++i) {
        m = rk4Step(m, 0.02, [&](const ShipMotion& x) { return ship.derivative(x, {0.2, {0.85}}, {}, {}); });
    }
    EXPECT_GT(m.surge_mps, 2.5);
    EXPECT_GT(m.heading_rad, 0.0);
    ShipMotion still;
    still = rk4Step(still, 0.02, [&](const ShipMotion& x) { return ship.derivative(x, {0.2, {}}, {}, {}); });
    EXPECT_EQ(still.surge_mps, 0.0);
    EXPECT_EQ(still.heading_rad, 0.0);
}

}  // namespace
}  // namespace sagara::core
