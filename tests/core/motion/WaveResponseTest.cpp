#include <gtest/gtest.h>

#include <memory>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "core/sea/Dispersion.h"
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
        EXPECT_NEAR(smithFactor(k, 21.73, kDeep_m) / row["depth_factor"], 1.0, 1e-9);
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

struct RegularWave {
    WaveTable table;
    SeaState sea;
    double wavesTo_rad, omega_radps, amplitude_m;

    RegularWave(double period_s, double towards_rad, double amplitude)
        : table(WaveTable::regular(kTwoPi / period_s, towards_rad, kDeep_m)),
          sea{{}, {0}, {amplitude}},
          wavesTo_rad(towards_rad),
          omega_radps(kTwoPi / period_s),
          amplitude_m(amplitude) {}
};

struct Amplitudes {
    double heave_m, roll_rad, pitch_rad;
};

/// Steady response at rest to a regular wave, heading held.
Amplitudes respond(const Vessel& vessel, const RegularWave& wave, double heading_rad) {
    const ShipDynamics ship(vessel, wave.table);
    auto waves = std::make_unique<ActiveWaves>();
    ShipMotion m;
    m.heading_rad = heading_rad;
    const double period_s = kTwoPi / wave.omega_radps, end_s = std::max(600.0, 12 * period_s);
    Amplitudes most{};
    for (double t = 0.0; t < end_s; t += 0.02) {
        activeWaves(wave.table, wave.sea, {static_cast<std::int64_t>((t + 0.01) * 1e6)}, *waves);
        const WaveEffect load = ship.waveLoad().at(wave.sea, *waves, {}, heading_rad, 1.0);
        m = rk4Step(m, 0.02, [&](const ShipMotion& x) { return ship.derivative(x, {}, {}, load, {}); });
        m.north_m = m.east_m = m.surge_mps = m.sway_mps = m.yawRate_radps = 0.0;
        m.heading_rad = heading_rad;
        if (t < end_s - 2 * period_s) continue;
        most.heave_m = std::max(most.heave_m, std::abs(m.down_m));
        most.roll_rad = std::max(most.roll_rad, std::abs(m.roll_rad));
        most.pitch_rad = std::max(most.pitch_rad, std::abs(m.pitch_rad));
    }
    return most;
}

double slope(const RegularWave& wave) {
    return wave.amplitude_m * wave.omega_radps * wave.omega_radps / kGravity_mps2;
}

/// A wave of ten natural periods: dynamic amplification is 1 / (1 - 1/100), so 1 within 1.1 % (heave and
/// pitch have damping and added mass that follow the water, which brings them closer).
TEST(LongWaves, CarryThePatrolVesselLikeACork) {
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const RegularWave wave(57.0, 0.4, 1.0);
    const Amplitudes ahead = respond(vessel, wave, wave.wavesTo_rad + kPi);
    EXPECT_NEAR(ahead.heave_m / wave.amplitude_m, 1.0, 0.01);
    EXPECT_NEAR(ahead.pitch_rad / slope(wave), 1.0, 0.01);
    EXPECT_NEAR(ahead.roll_rad / slope(wave), 0.0, 1e-6);
    const Amplitudes abeam = respond(vessel, wave, wave.wavesTo_rad + kPi / 2);
    EXPECT_NEAR(abeam.heave_m / wave.amplitude_m, 1.0, 0.01);
    EXPECT_NEAR(abeam.roll_rad / slope(wave), 1.0, 0.011);
    EXPECT_NEAR(abeam.pitch_rad / slope(wave), 0.0, 1e-6);
}

TEST(LongWaves, CarryTheTankerLikeACork) {
    const Vessel vessel = loadVessel("esso-osaka.json", test::readAsset("vessels/esso-osaka.json")).value();
    const RegularWave wave(170.0, 0.4, 1.0);  // natural roll period 17 s
    const Amplitudes ahead = respond(vessel, wave, wave.wavesTo_rad);
    EXPECT_NEAR(ahead.heave_m / wave.amplitude_m, 1.0, 0.01);
    EXPECT_NEAR(ahead.pitch_rad / slope(wave), 1.0, 0.01);
    const Amplitudes abeam = respond(vessel, wave, wave.wavesTo_rad + kPi / 2);
    EXPECT_NEAR(abeam.roll_rad / slope(wave), 1.0, 0.011);
}

TEST(WaveLoad, MirrorsBetweenThePortAndTheStarboardSide) {
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const RegularWave wave(8.0, 0.4, 0.5);
    const ShipDynamics ship(vessel, wave.table);
    auto waves = std::make_unique<ActiveWaves>();
    activeWaves(wave.table, wave.sea, SimTime::fromSeconds(31), *waves);
    const WaveEffect a = ship.waveLoad().at(wave.sea, *waves, {}, wave.wavesTo_rad + 0.7, 1.0);
    const WaveEffect b = ship.waveLoad().at(wave.sea, *waves, {}, wave.wavesTo_rad - 0.7, 1.0);
    EXPECT_NEAR(a.load.heave_N, b.load.heave_N, 1e-6 * std::abs(a.load.heave_N));
    EXPECT_NEAR(a.load.pitch_Nm, b.load.pitch_Nm, 1e-6 * std::abs(a.load.pitch_Nm));
    EXPECT_NEAR(a.load.roll_Nm, -b.load.roll_Nm, 1e-6 * std::abs(a.load.roll_Nm));
    EXPECT_NEAR(a.sway_mps2, -b.sway_mps2, 1e-6 * std::abs(a.sway_mps2));
    EXPECT_NEAR(a.yaw_radps2, -b.yaw_radps2, 1e-6 * std::abs(a.yaw_radps2));
}

TEST(WaveLoad, ShelterScalesEverything) {
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const RegularWave wave(8.0, 0.4, 0.5);
    const ShipDynamics ship(vessel, wave.table);
    auto waves = std::make_unique<ActiveWaves>();
    activeWaves(wave.table, wave.sea, SimTime::fromSeconds(31), *waves);
    const WaveEffect open = ship.waveLoad().at(wave.sea, *waves, {10, 20}, 1.0, 1.0);
    const WaveEffect lee = ship.waveLoad().at(wave.sea, *waves, {10, 20}, 1.0, 0.25);
    EXPECT_DOUBLE_EQ(lee.load.heave_N, 0.25 * open.load.heave_N);
    EXPECT_DOUBLE_EQ(lee.yaw_radps2, 0.25 * open.yaw_radps2);
}

TEST(WaveLoad, ShortWavesHardlyMoveALongShip) {
    const Vessel vessel = loadVessel("esso-osaka.json", test::readAsset("vessels/esso-osaka.json")).value();
    const RegularWave wave(6.0, 0.4, 1.0);  // 56 m against 325 m
    EXPECT_LT(respond(vessel, wave, wave.wavesTo_rad + kPi).heave_m, 0.05);
}

TEST(VerticalMotion, HeaveDecaysAtTheNaturalPeriod) {
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const WaveTable table(1, kDeep_m);
    const ShipDynamics ship(vessel, table);
    ShipMotion m;
    m.down_m = 0.5;
    double crossed_s = 0.0;
    for (double t = 0.0; crossed_s == 0.0 && t < 20.0; t += 0.001) {
        m = rk4Step(m, 0.001, [&](const ShipMotion& x) { return ship.derivative(x, {}, {}, {}, {}); });
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
