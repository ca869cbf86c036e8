#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/Propeller.h"

namespace sagara::core {
namespace {

constexpr double kWater_kgpm3 = 1025.0, kTurning = 0.7 * kPi;

PropulsionUnit unitOf(const BScrew& screw, double diameter_m) {
    PropulsionUnit unit;
    unit.diameter_m = diameter_m;
    OpenWater water;
    water.screw = screw;
    const auto t = screw.thrustPolynomial(), q = screw.torquePolynomial();
    water.thrust.assign(t.begin(), t.end());
    water.torque.assign(q.begin(), q.end());
    unit.openWater = water;
    return unit;
}

class Series : public ::testing::TestWithParam<BScrew> {};
TEST_P(Series, GoingAheadIsTheBSeriesWithinTheSpreadOfTheTwoRegressions) {
    const BScrew screw = GetParam();
    const double KT0 = screw.thrustCoefficient(0.0), KQ0 = screw.torqueCoefficient(0.0);
    for (double J = 0.0; J < 0.9 * screw.pitchRatio; J += 0.1) {
        const StarCoefficients c = fourQuadrants(std::atan2(J, kTurning), screw.pitchRatio, screw.areaRatio);
        const double scale = kPi / 8.0 * (J * J + kTurning * kTurning);
        EXPECT_NEAR(scale * c.thrust, screw.thrustCoefficient(J), 0.07 * KT0) << J;
        EXPECT_NEAR(scale * c.torque, screw.torqueCoefficient(J), 0.09 * KQ0) << J;
    }
}
INSTANTIATE_TEST_SUITE_P(Published, Series,
                         ::testing::Values(BScrew{4, 0.70, 0.5}, BScrew{4, 0.70, 0.8}, BScrew{4, 0.70, 1.0},
                                           BScrew{4, 0.70, 1.4}, BScrew{4, 0.40, 1.0}, BScrew{4, 1.00, 1.0},
                                           BScrew{4, 0.55, 0.9}));

TEST(FourQuadrants, HaveTheLimitsAndTrendsOfEveryPropeller) {
    for (const double pitch : {0.5, 0.7, 1.0, 1.3}) {
        const auto at = [&](double beta_deg) { return fourQuadrants(kDegree_rad * beta_deg, pitch, 0.7); };
        const double bollard = at(0).thrust;
        EXPECT_GT(bollard, 0.0);
        EXPECT_LT(at(90).thrust, -0.5) << "a locked screw drags like a plate";
        EXPECT_LT(at(90).torque, 0.0) << "and is turned ahead by the water";
        EXPECT_GT(at(270).thrust, 0.5);
        EXPECT_GT(at(270).torque, 0.0);
        EXPECT_LT(at(180).thrust, 0.0);
        EXPECT_LT(at(180).torque, 0.0);
        EXPECT_GT(at(180).thrust, -0.85 * bollard) << "astern a screw pushes less";
        EXPECT_LT(at(150).thrust, at(180).thrust) << "crash astern: more than at rest";
        EXPECT_GT(at(-30).thrust, bollard) << "ahead with sternway: more than at rest";
        EXPECT_NEAR(at(360).thrust, bollard, 1e-9);
        EXPECT_NEAR(at(-90).thrust, at(270).thrust, 1e-9);
    }
}

TEST(FourQuadrants, WindmillingScrewTurnsAheadAndDrags) {
    const PropulsionUnit unit = unitOf({4, 0.55, 0.9}, 3.0);
    const Propeller screw(unit);
    // Free: no torque. Some 0.7 to 1 of the pitch per turn.
    double slow_rps = 0.0, fast_rps = 4.0;
    for (int i = 0; i < 60; ++i) {
        const double n_rps = 0.5 * (slow_rps + fast_rps);
        (screw.force(n_rps, 1.0, 5.0, kWater_kgpm3).torque_Nm < 0.0 ? slow_rps : fast_rps) = n_rps;
    }
    const double J = 5.0 / (slow_rps * 3.0);
    EXPECT_GT(J, 0.9);
    EXPECT_LT(J, 1.5);
    EXPECT_LT(screw.force(slow_rps, 1.0, 5.0, kWater_kgpm3).thrust_N, 0.0);
    EXPECT_LT(screw.force(0.0, 1.0, 5.0, kWater_kgpm3).thrust_N,
              screw.force(slow_rps, 1.0, 5.0, kWater_kgpm3).thrust_N)
        << "locked it drags more";
}

class OwnPropeller : public ::testing::Test {
protected:
    OwnPropeller() : unit(unitOf({4, 0.431, 0.721}, 9.86)) {
        unit.openWater->thrust = {0.2931, -0.2753, -0.1385};  // KVLCC2, Yasukawa and Yoshimura (2015)
    }
    PropulsionUnit unit;
};

TEST_F(OwnPropeller, IsExactAheadFromRestToNoThrust) {
    const Propeller screw(unit);
    const double n_rps = 1.2, D_m = 9.86;
    for (double J = 0.0; J < 0.76; J += 0.05) {
        const PropellerForce f = screw.force(n_rps, 1.0, J * n_rps * D_m, kWater_kgpm3);
        const double scale_N = kWater_kgpm3 * n_rps * n_rps * std::pow(D_m, 4);
        EXPECT_NEAR(f.thrust_N / scale_N, 0.2931 - 0.2753 * J - 0.1385 * J * J, 1e-12);
        EXPECT_NEAR(f.torque_Nm / scale_N / D_m, unit.openWater->screw.torqueCoefficient(J), 1e-12);
    }
}

TEST_F(OwnPropeller, GoesOverIntoTheSeriesWithoutAStep) {
    unit.pitch = PitchControl{};
    const Propeller screw(unit);
    for (const double pitch : {-0.7, -0.2, 0.0, 0.3, 0.7, 1.0}) {
        PropellerForce before = screw.force(1.0, pitch, 0.0, kWater_kgpm3);
        const double most_N = 0.02 * screw.force(-1.0, 1.0, 8.0, kWater_kgpm3).thrust_N;
        for (double beta = 0.0; beta < kTwoPi; beta += 0.002) {
            const PropellerForce now =
                screw.force(std::cos(beta), pitch, kTurning * 9.86 * std::sin(beta), kWater_kgpm3);
            ASSERT_NEAR(now.thrust_N, before.thrust_N, std::abs(most_N)) << pitch << " at " << beta;
            before = now;
        }
    }
}

TEST(ControllablePitch, PushesByItsPitchAtTheSameRevolutions) {
    const Propeller screw(unitOf({4, 0.70, 1.0}, 2.0));
    const auto at = [&](double pitch, double inflow_mps) {
        return screw.force(5.0, pitch, inflow_mps, kWater_kgpm3);
    };
    double before = at(-1.0, 0.0).thrust_N;
    for (double pitch = -0.9; pitch < 1.01; pitch += 0.1) {
        EXPECT_GT(at(pitch, 0.0).thrust_N, before) << pitch;
        before = at(pitch, 0.0).thrust_N;
    }
    EXPECT_NEAR(at(0.0, 0.0).thrust_N, 0.0, 1e-9 * at(1.0, 0.0).thrust_N);
    EXPECT_GT(at(0.0, 0.0).torque_Nm, 0.0) << "blades without pitch still have friction";
    EXPECT_LT(at(0.0, 0.0).torque_Nm, 0.3 * at(1.0, 0.0).torque_Nm);
    EXPECT_LT(at(0.0, 4.0).thrust_N, at(0.0, 0.0).thrust_N) << "and stop the ship";
    EXPECT_GT(at(-0.7, 0.0).torque_Nm, 0.0) << "astern by pitch the shaft goes on turning ahead";
    // Less pitch is another propeller of the series.
    const BScrew lesser{4, 0.70, 0.7};
    for (const double J : {0.0, 0.2, 0.4}) {
        const double scale_N = kWater_kgpm3 * 25.0 * 16.0;
        EXPECT_NEAR(at(0.7, J * 10.0).thrust_N / scale_N, lesser.thrustCoefficient(J),
                    0.1 * lesser.thrustCoefficient(0.0));
        EXPECT_NEAR(at(0.7, J * 10.0).torque_Nm / scale_N / 2.0, lesser.torqueCoefficient(J),
                    0.1 * lesser.torqueCoefficient(0.0));
    }
}

TEST(Propeller, EssoOsakaWithFourQuadrantsHasTheThrustOfTheReport) {
    PropulsionUnit unit = unitOf({5, 0.682, 0.715}, 9.1);
    unit.openWater->thrust = {0.394, -0.197, -0.148};
    unit.wakeFraction = 0.352;
    const double thrust_N = Propeller(unit).behindHull(51.0 / 60.0, 1.0, 10 * kKnot_mps, 1025.0).thrust_N;
    EXPECT_NEAR(thrust_N / 1.43e6, 1.0, 0.005);
}

}  // namespace
}  // namespace sagara::core
