#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "core/sea/Dispersion.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"
#include "tests/support/ShippedVessels.h"
#include "tests/support/hulls/Tables.h"

namespace sagara::core {
namespace {

const Vessel& patrol() {
    static const Vessel vessel = loadVessel("opv48.json", test::readAsset("vessels/opv48.json")).value();
    return vessel;
}

/// Yaw alone at a held speed.
double yawRateAfter(const TransferShip& ship, double surge_mps, double rudder_rad, double seconds,
                    double start_radps = 0.0) {
    ShipMotion m;
    m.surge_mps = surge_mps;
    m.yawRate_radps = start_radps;
    constexpr double kStep_s = 0.01;
    for (double t = 0.0; t < seconds - kStep_s / 2; t += kStep_s) {
        m = rk4Step(m, kStep_s, [&](const ShipMotion& x) {
            ShipMotion rate;
            Actuators actuators;
            actuators.rudder_rad = rudder_rad;
            rate.yawRate_radps = ship.acceleration(x, actuators, {}).yaw_radps2;
            return rate;
        });
    }
    return m.yawRate_radps;
}

NomotoModel nomoto() {
    NomotoModel model;
    model.gain_perS = 0.12;
    model.timeConstant_s = 6.0;
    model.referenceSpeed_mps = 8.0;
    model.turningLoss = TransferModel::TurningLoss::None;
    return model;
}

TEST(Nomoto, YawRateFollowsTheClosedForm) {
    const TransferShip ship(nomoto(), patrol());
    for (const double t : {1.0, 6.0, 15.0, 40.0}) {
        EXPECT_NEAR(yawRateAfter(ship, 8.0, 0.3, t) / (0.12 * 0.3 * (1.0 - std::exp(-t / 6.0))), 1.0, 1e-6)
            << t;
    }
}

TEST(Nomoto, GainGrowsAndTimeConstantFallsWithSpeed) {
    const TransferShip ship(nomoto(), patrol());
    // at half the speed K is half and T twice as long
    EXPECT_NEAR(yawRateAfter(ship, 4.0, 0.3, 12.0) / (0.06 * 0.3 * (1.0 - std::exp(-1.0))), 1.0, 1e-6);
    EXPECT_NEAR(yawRateAfter(ship, -4.0, 0.3, 12.0) / (0.06 * 0.3 * (1.0 - std::exp(-1.0))), -1.0, 1e-6);
}

TEST(Nomoto, NorrbinTermBoundsTheSteadyTurnAndAnUnstableShipFindsHerOwn) {
    NomotoModel model = nomoto();
    model.cubic_s2 = 900.0;
    const double r = yawRateAfter(TransferShip(model, patrol()), 8.0, 0.3, 200.0);
    EXPECT_NEAR(r + 900.0 * r * r * r, 0.12 * 0.3, 1e-9);
    model.linear = -1.0;
    EXPECT_NEAR(yawRateAfter(TransferShip(model, patrol()), 8.0, 0.0, 400.0, 1e-3), std::sqrt(1.0 / 900.0),
                1e-9);
}

TEST(Nomoto, LosesNoSpeedInTheTurn) {
    const TransferShip ship(nomoto(), patrol());
    ShipMotion m;
    m.surge_mps = 8.0;
    m.sway_mps = -1.0;
    m.yawRate_radps = 0.05;
    ShipMotion straight;
    straight.surge_mps = 8.0;
    EXPECT_EQ(ship.acceleration(m, {}, {}).surge_mps2, ship.acceleration(straight, {}, {}).surge_mps2);
}

TEST(HalfDifferences, AgreeWithTheReferenceIntegrals) {
    const Waterplane esso{325.0, 53.0};
    const double scale = 325.0 * 53.0;  // tolerance of the file: 1e-9 of l w
    for (const test::Row& row : test::readReference("paper/closed_form_integrals.csv")) {
        const double rel = row["rel_deg"] * kDegree_rad, k = row["k"];
        const WaveHeights h = waveHeights(esso, k * std::cos(rel), k * std::sin(rel), row["phi"]);
        EXPECT_NEAR(h.sum_m3, row["integral"], 1e-9 * scale);
        EXPECT_NEAR(h.along_m3, row["half_difference_x"], 1e-9 * scale);
        EXPECT_NEAR(h.across_m3, row["half_difference_y"], 1e-9 * scale);
    }
}

struct Swing {
    double heave = 0.0, roll = 0.0,
           pitch = 0.0;  ///< half of what lies between the extremes, over wave and slope
};

/// At rest in a regular wave from ahead (or from abeam, for roll), over the last of some periods.
Swing swingIn(const std::string& model, double period_s, double heading_rad, int periods) {
    const double omega = kTwoPi / period_s, k = omega * omega / kGravity_mps2, amplitude_m = 0.1;
    const WaveTable table = WaveTable::regular(omega, 0.0, kDeep_m);
    const SeaState sea{{}, {0}, {amplitude_m}};
    const ShipDynamics ship(patrol(), model, test::seaHulls()->of(patrol().hull));
    MovingShip moving;
    moving.motion.heading_rad = heading_rad;
    const ShipMotion still = moving.motion;  // waves of one place
    Swing low, high;
    constexpr double kStep_s = 0.02;
    const auto steps = static_cast<int>(period_s * periods / kStep_s),
               last = static_cast<int>(period_s / kStep_s);
    for (int i = 0; i < steps; ++i) {
        ActiveWaves waves;
        activeWaves(table, sea, SimTime{static_cast<std::int64_t>(1e6 * (i + 0.5) * kStep_s)}, waves);
        const WaveEffect effect = ship.wavesAt(waves, still, 1.0);
        moving = rk4Step(moving, kStep_s,
                         [&](const MovingShip& x) { return ship.derivative(x, {}, {}, effect, {}); });
        const ShipMotion& m = moving.motion;
        const bool first = i == steps - last;
        if (i < steps - last) continue;
        const auto widen = [&](double& lowest, double& highest, double x) {
            lowest = first ? x : std::min(lowest, x);
            highest = first ? x : std::max(highest, x);
        };
        widen(low.heave, high.heave, m.down_m);
        widen(low.roll, high.roll, m.roll_rad);
        widen(low.pitch, high.pitch, m.pitch_rad);
    }
    const double slope = k * amplitude_m;
    return {0.5 * (high.heave - low.heave) / amplitude_m, 0.5 * (high.roll - low.roll) / slope,
            0.5 * (high.pitch - low.pitch) / slope};
}

TEST(PrintedPaper, AnswerToLongWavesGrowsWithTheSquareOfThePeriodAndTheCorrectedFormsDoesNot) {
    const double head = kPi;
    const Swing at40 = swingIn("sandaruwan2010-printed", 40.0, head, 1),
                at80 = swingIn("sandaruwan2010-printed", 80.0, head, 1);
    EXPECT_GT(at40.heave, 20.0);
    EXPECT_GT(at80.heave, 3.0 * at40.heave);
    const Swing corrected = swingIn("sandaruwan2010", 40.0, head, 6);
    EXPECT_NEAR(corrected.heave, 1.0, 0.02);
    EXPECT_NEAR(corrected.pitch, 1.0, 0.03);
    EXPECT_NEAR(swingIn("sandaruwan2010", 80.0, 0.5 * kPi, 30).roll, 1.0, 0.03);
}

TEST(PrintedPaper, HeaveDampingHasOneSignAndDrivesHerAway) {
    const ShipDynamics ship(patrol(), "sandaruwan2010-printed");
    ShipMotion sinking, rising;
    sinking.heaveRate_mps = 1.0;
    rising.heaveRate_mps = -1.0;
    EXPECT_EQ(ship.derivative(sinking, {}, {}, {}).heaveRate_mps, 0.01);
    EXPECT_EQ(ship.derivative(rising, {}, {}, {}).heaveRate_mps, 0.01);
}

TEST(Ueng, FollowsLongWavesByTheirHeights) {
    const Swing s = swingIn("ueng2008", 40.0, kPi, 6);
    EXPECT_NEAR(s.heave, 1.0, 0.02);
    EXPECT_NEAR(s.pitch, 1.0, 0.03);
    EXPECT_NEAR(swingIn("ueng2008", 60.0, 0.5 * kPi, 8).roll, 1.0, 0.05);
}

TEST(Ueng, YawDoesNotMakeHerDrift) {
    const ShipDynamics ship(patrol(), "ueng2008");
    ShipMotion m;
    m.surge_mps = 8.0;
    for (int i = 0; i < 5000; ++i) {
        m = rk4Step(m, 0.02, [&](const ShipMotion& x) {
            return ship.derivative(x, {0.3, {9.0, 9.0}}, {}, {});
        });
    }
    EXPECT_GT(m.yawRate_radps, 0.01);
    EXPECT_EQ(m.sway_mps, 0.0);
}

TEST(Barauskis, IsBlindToWaves) {
    const Swing s = swingIn("barauskis2007", 8.0, kPi, 4);
    EXPECT_EQ(s.heave, 0.0);
    EXPECT_EQ(s.pitch, 0.0);
    EXPECT_EQ(swingIn("barauskis2007", 8.0, 0.5 * kPi, 4).roll, 0.0);
}

/// Every model of every shipped vessel, an hour of orders of all kinds.
class EveryModel : public ::testing::TestWithParam<std::string> {};
TEST_P(EveryModel, StaysFiniteThroughAnHourOfOrders) {
    const Vessel vessel = loadVessel(GetParam(), test::readAsset("vessels/" + GetParam() + ".json")).value();
    for (const NamedModel& model : vessel.models) {
        if (model.name == "sandaruwan2010-printed") continue;
        const ShipDynamics ship(vessel, model.name);
        ShipMotion m;
        Actuators actuators;
        for (int i = 0; i < 36000; ++i) {
            const double t = 0.1 * i;
            actuators.rudder_rad = 0.6 * std::sin(t / 97.0);
            actuators.shaft_rps.fill(vessel.propulsion.telegraph_rps.back() * std::sin(t / 311.0));
            m = rk4Step(m, 0.1, [&](const ShipMotion& x) { return ship.derivative(x, actuators, {}, {}); });
        }
        EXPECT_LT(std::hypot(m.surge_mps, m.sway_mps), 20.0) << model.name;
        EXPECT_LT(std::abs(m.yawRate_radps), std::sqrt(kGravity_mps2 / vessel.hull.lengthBp_m)) << model.name;
        EXPECT_LT(std::abs(m.roll_rad), 1.0) << model.name;
    }
}
INSTANTIATE_TEST_SUITE_P(Assets, EveryModel, ::testing::ValuesIn(test::shippedVessels()),
                         [](const auto& row) { return test::testName(row.param); });

}  // namespace
}  // namespace sagara::core
