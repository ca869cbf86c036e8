#include "core/motion/Thruster.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

class Tunnel : public ::testing::Test {
protected:
    Tunnel() {
        hull.lengthBp_m = 100.0;
        hull.waterDensity_kgpm3 = 1025.0;
        bow = {"bow", {45.0, 0.0}, -3.0, 2.0, 150e3, 5.0};
        stern = bow;
        stern.position.x_m = -45.0;
    }
    Load at(const Thruster& t, double share, double surge_mps) const {
        return thrusterLoad(t, share, surge_mps, hull);
    }
    Hull hull;
    Thruster bow, stern;
};

TEST_F(Tunnel, AtRestPushesWithItsWholeThrustAtItsPlace) {
    const Load l = at(bow, 1.0, 0.0);
    EXPECT_DOUBLE_EQ(l.sway_N, 150e3);
    EXPECT_DOUBLE_EQ(l.yaw_Nm, 45.0 * 150e3);
    EXPECT_DOUBLE_EQ(l.roll_Nm, -3.0 * 150e3) << "below the waterline, to starboard: she heels to port";
    EXPECT_EQ(l.surge_N, 0.0);
    const Load port = at(bow, -0.5, 0.0);
    EXPECT_DOUBLE_EQ(port.sway_N, -75e3);
    EXPECT_EQ(at(bow, 0.0, 3.0).sway_N, 0.0);
}

TEST_F(Tunnel, LosesForceAndLessOfItsMomentAsTheShipMovesAhead) {
    const double jet_mps = jetSpeed_mps(bow, bow.thrust_N, 1025.0);
    EXPECT_NEAR(jet_mps, std::sqrt(150e3 / (1025.0 * kPi)), 1e-12);
    double force = 1.0, moment = 1.0;
    for (const double ratio : {0.1, 0.2, 0.3, 0.4}) {
        const Load l = at(bow, 1.0, ratio * jet_mps);
        EXPECT_LT(l.sway_N / 150e3, force);
        EXPECT_LT(l.yaw_Nm / (45.0 * 150e3), moment);
        force = l.sway_N / 150e3, moment = l.yaw_Nm / (45.0 * 150e3);
        EXPECT_GT(moment, force) << "the suction acts aft of the tunnel";
    }
    // A third of the jet's speed: half of the force, as every one of the published curves has it.
    EXPECT_NEAR(thrusterFade(0.3).force, 0.5, 0.1);
    EXPECT_NEAR(thrusterFade(0.3).moment, 0.74, 0.1);
    EXPECT_EQ(thrusterFade(5.0).force, thrusterFade(1.0).force);
}

TEST_F(Tunnel, TheSternThrusterLosesGoingAsternWhatTheBowThrusterLosesGoingAhead) {
    for (const double speed_mps : {0.5, 1.5, 3.0}) {
        EXPECT_NEAR(at(bow, 1.0, speed_mps).sway_N, at(stern, 1.0, -speed_mps).sway_N, 1e-9);
        EXPECT_NEAR(at(bow, 1.0, speed_mps).yaw_Nm, -at(stern, 1.0, -speed_mps).yaw_Nm, 1e-9);
        EXPECT_GT(at(stern, 1.0, speed_mps).sway_N, 0.95 * 150e3);
        EXPECT_NEAR(at(bow, -1.0, speed_mps).sway_N, -at(bow, 1.0, speed_mps).sway_N, 1e-9);
    }
}

TEST_F(Tunnel, AtPartOfItsPowerIsBentByLessSpeed) {
    EXPECT_LT(at(bow, 0.25, 1.0).sway_N / 0.25, at(bow, 1.0, 1.0).sway_N);
}

TEST(TunnelThrust, IsUsualForThePower) {
    // Makers' lists: some 0.13 to 0.17 kN per kW.
    EXPECT_NEAR(tunnelThrust_N(1e6, 2.0, 1025.0), 150e3, 20e3);
    EXPECT_NEAR(tunnelThrust_N(1e5, 0.75, 1025.0), 16e3, 2e3);
}

}  // namespace
}  // namespace sagara::core
