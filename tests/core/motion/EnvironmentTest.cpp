#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/motion/CrossFlow.h"
#include "core/motion/Propeller.h"
#include "core/motion/Squat.h"
#include "core/motion/WindLoad.h"
#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Windage windageOf(const test::Row& row) {
    return {*findBlendermannType(row.text("type")), row["AF"], row["AL"], row["sL"], row["sH"], {}};
}

TEST(Blendermann, CoefficientsAgreeWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("environment/blendermann1994_check.csv")) {
        const WindCoefficients c = windCoefficients(windageOf(row), row["Loa"], row["angle"] * kDegree_rad);
        // relative 1e-6 of the file, and of one where the value is a rounding of zero
        EXPECT_NEAR(c.CX, row["CX"], 1e-6 * std::max(std::abs(row["CX"]), 1.0))
            << row.text("type") << row["angle"];
        EXPECT_NEAR(c.CY, row["CY"], 1e-6);
        EXPECT_NEAR(c.CK, row["CK"], 1e-6 * std::max(std::abs(row["CK"]), 1.0));
        EXPECT_NEAR(c.CN, row["CN"], 1e-6);
    }
}

class WindOnPatrol : public ::testing::Test {
protected:
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    Load load(double speed_mps, double from_deg, double heading_deg, BodyPoint ground = {}) const {
        return windLoad(vessel.windage, vessel.hull.lengthOverall_m, {speed_mps, from_deg * kDegree_rad},
                        heading_deg * kDegree_rad, ground);
    }
};

TEST_F(WindOnPatrol, PushesAwayFromWhereItComes) {
    EXPECT_LT(load(10, 0, 0).surge_N, 0.0);                              // on the bow: back
    EXPECT_GT(load(10, 180, 0).surge_N, 0.0);                            // from astern: forward
    EXPECT_LT(load(10, 90, 0).sway_N, 0.0);                              // on the starboard side: to port
    EXPECT_LT(load(10, 90, 0).roll_Nm, 0.0);                             // and heels to port
    EXPECT_GT(load(10, 315, 0).yaw_Nm, 0.0);                             // on the port bow: bow to starboard
    EXPECT_NEAR(load(10, 60, 20).sway_N, load(10, 40, 0).sway_N, 1e-9);  // only the relative direction counts
    EXPECT_NEAR(load(10, 40, 0).sway_N, -load(10, -40, 0).sway_N, 1e-9);
}

TEST_F(WindOnPatrol, CalmAirAddsNothingAtAnySpeed) {
    const Load none = load(0, 0, 30, {8.0, 1.0});
    EXPECT_EQ(none.surge_N, 0.0);
    EXPECT_EQ(none.yaw_Nm, 0.0);
}

TEST_F(WindOnPatrol, BeamWindOf10KnotsIsAFewKilonewtons) {
    // 1/2 rho V^2 AL CY = 0.5 x 1.225 x 5.144^2 x 230 x 0.85
    EXPECT_NEAR(-load(10 * kKnot_mps, 90, 0).sway_N, 3169.0, 5.0);
}

TEST(CrossFlow, PureSwayAndPureSwingHaveTheirClosedForms) {
    Hull hull;
    hull.lengthBp_m = 50.0;
    hull.draught_m = 2.0;
    hull.waterDensity_kgpm3 = 1000.0;
    EXPECT_NEAR(crossFlowDrag(hull, 1.0, 2.0, 0.0).sway_N, -0.5 * 1000 * 2 * 50 * 4.0, 1e-6);
    EXPECT_NEAR(crossFlowDrag(hull, 1.0, 2.0, 0.0).yaw_Nm, 0.0, 1e-6);
    const double exact = -0.5 * 1000 * 2 * 0.1 * 0.1 * std::pow(50.0, 4) / 32;  // integral of x^3
    EXPECT_NEAR(crossFlowDrag(hull, 1.0, 0.0, 0.1).yaw_Nm / exact, 1.0, 0.02);  // 12 strips
    EXPECT_NEAR(crossFlowDrag(hull, 1.0, 0.0, 0.1).sway_N, 0.0, 1e-6);
}

TEST(Propeller, EssoOsakaThrustIsTheReferences) {
    const Vessel vessel = loadVessel("esso-osaka.json", test::readAsset("vessels/esso-osaka.json")).value();
    const double thrust_N =
        Propeller(vessel.propulsion.units[0]).behindHull(51.0 / 60.0, 1.0, 10 * kKnot_mps, 1025.0).thrust_N;
    EXPECT_NEAR(thrust_N / 1'430'126.0, 1.0,
                0.001);  // esso_osaka_particulars.json, self-consistency at 10 kn
}

TEST(Propeller, PushesTheRightWayInEveryQuadrant) {
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const PropulsionUnit& unit = vessel.propulsion.units[0];
    const auto thrust = [&](double rps, double u) {
        return Propeller(unit).behindHull(rps, 1.0, u, 1025.0).thrust_N;
    };
    EXPECT_GT(thrust(3, 0), 0.0);
    EXPECT_GT(thrust(3, -2), thrust(3, 0));  // ahead with sternway: more
    EXPECT_LT(thrust(3, 3), thrust(3, 0));   // ahead with headway: less
    EXPECT_LT(thrust(3, 8), 0.0);            // dragged
    EXPECT_LT(thrust(-3, 0), 0.0);
    EXPECT_EQ(thrust(-3, 4), thrust(-3, 0));   // astern with headway: as at rest
    EXPECT_GT(thrust(-3, -2), thrust(-3, 0));  // astern with sternway: less
    EXPECT_NEAR(thrust(-3, 0) / thrust(3, 0), -unit.asternThrustRatio, 1e-12);
    EXPECT_EQ(thrust(0, 5), 0.0);
}

TEST(Squat, IsBarrassInShallowWaterAndNothingInDeep) {
    EXPECT_NEAR(squat_m(0.831, 5 * kKnot_mps, 26.08, 21.73), 0.20775,
                1e-9);  // squat_check.csv, barrass_simple
    EXPECT_EQ(squat_m(0.831, 5 * kKnot_mps, 80.0, 21.73), 0.0);
}

}  // namespace
}  // namespace sagara::core
