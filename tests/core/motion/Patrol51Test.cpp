#include <gtest/gtest.h>

#include "core/base/Angle.h"
#include "core/motion/PolynomialShip.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

/// Of the reference runs: their zigzag turns the rudder at the first step past 10 deg.
constexpr double kStep_s = 0.01;

/// The shipped vessel in calm water without wind, driven as in the reference runs.
class Patrol51 : public ::testing::Test {
protected:
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const ShipDynamics ship{vessel};
    const PolynomialShip model{std::get<PolynomialModel>(vessel.models[0].parameters), vessel};

    ShipMotion motion;
    double rudder_rad = 0.0;
    double shaft_rps = 7.0;  ///< holds 8 m/s straight, as the published constant thrust
    double time_s = 0.0;

    Patrol51() { motion.surge_mps = 8.0; }

    /// One tick; the rudder runs at its rate and acts with its mean over the tick.
    void step(double order_rad) {
        const double most = vessel.steering.rate_radps * kStep_s;
        const double next_rad = rudder_rad + std::clamp(order_rad - rudder_rad, -most, most);
        const Actuators actuators{0.5 * (rudder_rad + next_rad), {shaft_rps, shaft_rps}};
        motion = rk4Step(motion, kStep_s,
                         [&](const ShipMotion& m) { return ship.derivative(m, actuators, {}, {}); });
        rudder_rad = next_rad;
        time_s += kStep_s;
    }

    double position_m(const test::Row& row) const {
        return distance(motion.position(), {row["x"], row["y"]});
    }
};

TEST_F(Patrol51, TurningCircleIsThePublishedModels) {
    for (const test::Row& row : test::readReference("manoeuvring/patrol51_turn_p20.csv")) {
        while (time_s < row["t"] - kStep_s / 2) step(20.0 * kDegree_rad);
        // tolerance of the file: 0.2 % of L, 0.2 deg heading, 0.1 deg roll
        ASSERT_LE(position_m(row), 0.002 * 51.5) << time_s;
        ASSERT_NEAR(motion.heading_rad / kDegree_rad, row["psi"], 0.2) << time_s;
        ASSERT_NEAR(motion.roll_rad / kDegree_rad, row["phi"], 0.1) << time_s;
    }
}

TEST_F(Patrol51, ZigzagIsThePublishedModels) {
    double order_rad = 10.0 * kDegree_rad;
    double worstHeading_deg = 0.0;
    for (const test::Row& row : test::readReference("manoeuvring/patrol51_zz_10_10.csv")) {
        while (time_s < row["t"] - kStep_s / 2) {
            step(order_rad);
            if (order_rad > 0 && motion.heading_rad >= 10.0 * kDegree_rad) order_rad = -10.0 * kDegree_rad;
            if (order_rad < 0 && motion.heading_rad <= -10.0 * kDegree_rad) order_rad = 10.0 * kDegree_rad;
        }
        ASSERT_LE(position_m(row), 0.002 * 51.5) << time_s;
        ASSERT_NEAR(motion.roll_rad / kDegree_rad, row["phi"], 0.1) << time_s;
        worstHeading_deg =
            std::max(worstHeading_deg, std::abs(motion.heading_rad / kDegree_rad - row["psi"]));
    }
    EXPECT_LE(worstHeading_deg, 0.2);
}

TEST_F(Patrol51, RollDecayIsThePublishedModels) {
    motion.roll_rad = 15.0 * kDegree_rad;
    for (const test::Row& row : test::readReference("manoeuvring/patrol51_roll_decay_8ms_15deg.csv")) {
        while (time_s < row["t"] - kStep_s / 2) step(0.0);
        ASSERT_NEAR(motion.roll_rad / kDegree_rad, row["phi"], 0.1) << time_s;
        ASSERT_NEAR(motion.heading_rad / kDegree_rad, row["psi"], 0.1) << time_s;
    }
}

double measure(const std::string& run, const std::string& name) {
    for (const test::Row& row : test::readReference("manoeuvring/patrol51_measures.csv")) {
        if (row.text("run") == run && row.text("measure") == name) return row["value"];
    }
    throw std::runtime_error(name);
}

TEST_F(Patrol51, TurningMeasuresAreWithinHalfAPercent) {
    double advance_m = 0.0, transfer_m = 0.0, tacticalDiameter_m = 0.0;
    while (motion.heading_rad < kPi) {
        const double before = motion.heading_rad;
        step(20.0 * kDegree_rad);
        if (before < kPi / 2 && motion.heading_rad >= kPi / 2) {
            advance_m = motion.north_m;
            transfer_m = motion.east_m;
        }
        tacticalDiameter_m = motion.east_m;
    }
    EXPECT_NEAR(advance_m / 51.5 / measure("turn_p20", "advance_over_L"), 1.0, 0.005);
    EXPECT_NEAR(transfer_m / 51.5 / measure("turn_p20", "transfer_over_L"), 1.0, 0.005);
    EXPECT_NEAR(tacticalDiameter_m / 51.5 / measure("turn_p20", "tactical_diameter_over_L"), 1.0, 0.005);
}

TEST_F(Patrol51, TurnToPortMirrorsTheTurnToStarboard) {
    ShipMotion mirrored;
    for (int i = 0; i < 4000; ++i) step(20.0 * kDegree_rad);
    mirrored = motion;
    motion = {};
    motion.surge_mps = 8.0;
    rudder_rad = 0.0;
    for (int i = 0; i < 4000; ++i) step(-20.0 * kDegree_rad);
    // The published phi-terms are even in the turn, so the mirror is exact but for rounding.
    EXPECT_NEAR(motion.east_m, -mirrored.east_m, 1e-6);
    EXPECT_NEAR(motion.heading_rad, -mirrored.heading_rad, 1e-9);
}

// --- the low-speed extension ---

TEST_F(Patrol51, ExtensionIsExactlyZeroInThePublishedRange) {
    PolynomialModel published = std::get<PolynomialModel>(vessel.models[0].parameters);
    published.lift->crossFlowDrag = 0.0;
    Vessel without = vessel;
    without.steering.raceShare = 0.0;
    for (PropulsionUnit& unit : without.propulsion.units) unit.thrustCoefficients = {};
    const PolynomialShip bare(published, without);
    for (const double u : {4.0, 5.0, 6.5, 8.0, 9.0}) {
        ShipMotion m;
        m.surge_mps = u;
        m.sway_mps = -0.8;
        m.yawRate_radps = 0.03;
        m.roll_rad = -0.05;
        const Actuators actuators{0.2, {3.0, 5.0}};
        const PlanarAcceleration a = model.acceleration(m, actuators, {}),
                                 b = bare.acceleration(m, actuators, {});
        EXPECT_EQ(a.surge_mps2, b.surge_mps2) << u;
        EXPECT_EQ(a.sway_mps2, b.sway_mps2) << u;
        EXPECT_EQ(a.yaw_radps2, b.yaw_radps2) << u;
        EXPECT_EQ(a.roll_radps2, b.roll_radps2) << u;
    }
}

TEST_F(Patrol51, ForcesAreContinuousIntoTheExtension) {
    ShipMotion m;
    m.sway_mps = -0.4;
    m.yawRate_radps = 0.02;
    PlanarAcceleration before{};
    for (double u = -4.0; u < 9.0; u += 0.001) {
        m.surge_mps = u;
        const PlanarAcceleration now = model.acceleration(m, {0.3, {3.5, 3.5}}, {});
        if (u > -4.0) {
            EXPECT_NEAR(now.surge_mps2, before.surge_mps2, 2e-3) << u;
            EXPECT_NEAR(now.yaw_radps2, before.yaw_radps2, 1e-4) << u;
        }
        before = now;
    }
}

TEST_F(Patrol51, PublishedThrustAndPropellerAgreeAtTheSelfPropulsionPoint) {
    for (const double u : {2.0, 3.5, 8.0}) {  // below, across and above the change
        ShipMotion m;
        m.surge_mps = u;
        const double rps = 7.0 * u / 8.0;
        EXPECT_NEAR(model.hullForces(m, {0.0, {rps, rps}}).propeller.surge_N / (1960.0 * u * u), 1.0, 0.01)
            << u;
    }
}

TEST_F(Patrol51, BacksWhenTheShaftsGoAsternAndStopsInAFewLengths) {
    double headReach_m = 0.0;
    while (time_s < 120.0) {
        shaft_rps = std::max(-5.5, shaft_rps - vessel.propulsion.units[0].shaftRate_rpsps * kStep_s);
        step(0.0);
        if (motion.surge_mps > 0.0) headReach_m = motion.north_m;
    }
    EXPECT_LT(motion.surge_mps, -1.5);
    // Full astern from 15.5 kn. Resistance alone takes off 0.33 m/s2; trend only: light craft stop in 2 to 8
    // lengths.
    EXPECT_GT(headReach_m, 2.0 * 51.5);
    EXPECT_LT(headReach_m, 8.0 * 51.5);
}

TEST_F(Patrol51, TurnsOnTheSpotWithTheScrewsOpposed) {
    motion.surge_mps = 0.0;
    for (int i = 0; i < 100 * 90; ++i) {  // port ahead, starboard astern: bow to starboard
        const Actuators actuators{0.0, {2.6, -3.2}};
        motion = rk4Step(motion, kStep_s,
                         [&](const ShipMotion& m) { return ship.derivative(m, actuators, {}, {}); });
    }
    EXPECT_GT(motion.heading_rad, 40.0 * kDegree_rad);
    EXPECT_LT(length(motion.position()), 51.5 / 2);
}

TEST_F(Patrol51, RudderInTheRaceKicksTheSternFromRest) {
    motion.surge_mps = 0.0;
    const Actuators ahead{20.0 * kDegree_rad, {2.0, 2.0}}, stopped{20.0 * kDegree_rad, {0.0, 0.0}};
    EXPECT_GT(model.hullForces(motion, ahead).rudder.yaw_Nm, 100e3);
    EXPECT_EQ(model.hullForces(motion, stopped).rudder.yaw_Nm, 0.0);
}

TEST_F(Patrol51, DriftAtRestIsResistedAsTheSourceSays) {
    motion.surge_mps = 0.0;
    motion.sway_mps = 1.0;
    const double drag_N = -model.hullForces(motion, {}).hull.sway_N;  // "about 45-50 kN s2/m2"
    EXPECT_GE(drag_N, 45e3);
    EXPECT_LE(drag_N, 50e3);
}

TEST_F(Patrol51, HalfTheStepIsASixteenthOfTheError) {
    const auto run = [&](double dt) {
        ShipMotion m;
        m.surge_mps = 8.0;
        const int steps = static_cast<int>(std::lround(20.0 / dt));
        for (int i = 0; i < steps; ++i) {
            m = rk4Step(m, dt, [&](const ShipMotion& x) {
                return ship.derivative(x, {0.3, {7.0, 7.0}}, {}, {});
            });
        }
        return m.heading_rad;
    };
    const double exact = run(0.0125), coarse = std::abs(run(0.2) - exact), fine = std::abs(run(0.1) - exact);
    EXPECT_NEAR(coarse / fine, 16.0, 3.0);
}

}  // namespace
}  // namespace sagara::core
