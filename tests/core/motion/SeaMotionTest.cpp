#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "core/sea/Dispersion.h"
#include "core/seakeeping/Response.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"
#include "tests/support/hulls/Tables.h"

namespace sagara::core {
namespace {

Vessel shipped(const std::string& id) {
    return loadVessel(id + ".json", test::readAsset("vessels/" + id + ".json")).value();
}

ShipMotion moving(NorthEast at, double heading_rad, double surge_mps) {
    ShipMotion m;
    m.north_m = at.north_m;
    m.east_m = at.east_m;
    m.heading_rad = heading_rad;
    m.surge_mps = surge_mps;
    return m;
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
    std::unique_ptr<ActiveWaves> at(double time_s) const {
        auto waves = std::make_unique<ActiveWaves>();
        activeWaves(table, sea, {static_cast<std::int64_t>(time_s * 1e6)}, *waves);
        return waves;
    }
    double slope() const { return amplitude_m * omega_radps * omega_radps / kGravity_mps2; }
};

/// What goes with the wave, over wave and slope; heave of the centre of gravity. Without bilge keels the roll
/// of the start rings on for an hour: it is another frequency's.
struct Swing {
    double heave = 0.0, roll = 0.0, pitch = 0.0;
};

/// Adrift, free in all six (or with her heading held, in the waves of one place), over the last third of some
/// periods, with Hann's window.
Swing adrift(const Vessel& vessel, const RegularWave& wave, double heading_rad, double periods,
             bool headingHeld = false) {
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    const double forward_m = hullFormOf(vessel.hull).gravityForward_m;
    MovingShip m;
    m.motion.heading_rad = heading_rad;
    const double period_s = kTwoPi / wave.omega_radps, end_s = periods * period_s, step_s = 0.04;
    const double watched_s = std::floor(periods / 3.0) * period_s;
    std::complex<double> heave, roll, pitch;
    for (double t = 0.0; t < end_s; t += step_s) {
        const auto waves = wave.at(t + 0.5 * step_s);
        ShipMotion there = m.motion;
        if (headingHeld) there.north_m = there.east_m = 0.0;
        const WaveEffect effect = ship.wavesAt(*waves, there, 1.0);
        m = rk4Step(m, step_s, [&](const MovingShip& x) { return ship.derivative(x, {}, {}, effect, {}); });
        if (headingHeld) {
            m.motion.heading_rad = heading_rad;
            m.motion.yawRate_radps = 0.0;
        }
        const double on_s = t + step_s - (end_s - watched_s);
        if (on_s < 0.0) continue;
        const double window = 1.0 - std::cos(kTwoPi * on_s / watched_s);
        const auto turn = std::polar(2.0 * window * step_s / watched_s, -wave.omega_radps * on_s);
        heave += turn * (m.motion.down_m - forward_m * m.motion.pitch_rad);
        roll += turn * m.motion.roll_rad;
        pitch += turn * m.motion.pitch_rad;
    }
    return {std::abs(heave) / wave.amplitude_m, std::abs(roll) / wave.slope(),
            std::abs(pitch) / wave.slope()};
}

/// Ten times the natural periods: the issue asks for 1 within 1 %; roll of a light wave passes an undamped
/// spring's 1 / (1 - 1/100).
struct LongWave {
    const char* vessel;
    double period_s;
};
class LongWaves : public ::testing::TestWithParam<LongWave> {};
TEST_P(LongWaves, CarryTheWholeShipLikeACork) {
    const Vessel vessel = shipped(GetParam().vessel);
    const RegularWave wave(GetParam().period_s, 0.4, 0.5);
    const Swing ahead = adrift(vessel, wave, wave.wavesTo_rad + kPi, 6.0);
    EXPECT_NEAR(ahead.heave, 1.0, 0.01);
    EXPECT_NEAR(ahead.pitch, 1.0, 0.01);
    EXPECT_NEAR(ahead.roll, 0.0, 1e-6);
    const Swing abeam = adrift(vessel, wave, wave.wavesTo_rad + 0.5 * kPi, 12.0);
    EXPECT_NEAR(abeam.heave, 1.0, 0.01);
    EXPECT_NEAR(abeam.roll, 1.0, 0.02);
}
INSTANTIATE_TEST_SUITE_P(Shipped, LongWaves,
                         ::testing::Values(LongWave{"patrol51", 65.0}, LongWave{"esso-osaka", 170.0},
                                           LongWave{"kvlcc2", 210.0}),
                         [](const auto& row) {
                             std::string name = row.param.vessel;
                             std::erase(name, '-');
                             return name;
                         });

/// Responses of the ship with her manoeuvring model against those of her hull in the frequency domain. Hers
/// has viscous forces in sway and yaw and its own inertia there; heave and pitch must not notice.
TEST(SeaMotion, AtRestSheAnswersAsHerHullDoesInTheFrequencyDomain) {
    for (const char* id : {"kvlcc2", "patrol51"}) {
        const Vessel vessel = shipped(id);
        const HullForm form = hullFormOf(vessel.hull);
        const HullResponse hull(form);
        for (const double lambdaOverL : {0.8, 1.2, 2.0}) {
            const double omega = std::sqrt(kTwoPi * kGravity_mps2 / (lambdaOverL * vessel.hull.lengthBp_m));
            const RegularWave wave(kTwoPi / omega, 0.4, 0.1);
            const WaveResponse r = hull.respond({omega, kPi, 0.0}, 0.2);
            const Swing s = adrift(vessel, wave, wave.wavesTo_rad + kPi, 25.0);
            const double k = omega * omega / kGravity_mps2;
            const double heave = std::abs(r.atGravity[2]), pitch = std::abs(r.atGravity[4]) / k;
            EXPECT_NEAR(s.heave, heave, 0.03 * std::max(0.3, heave)) << id << " " << lambdaOverL;
            EXPECT_NEAR(s.pitch, pitch, 0.03 * std::max(0.3, pitch)) << id << " " << lambdaOverL;
        }
    }
}

TEST(SeaMotion, WithTheSeaAbeamSheRollsAsHerHullDoesInTheFrequencyDomain) {
    const Vessel vessel = shipped("kvlcc2");
    const HullResponse hull(hullFormOf(vessel.hull));
    const double natural = test::seaHulls()->of(vessel.hull)->rollFrequency_radps;
    for (const double share : {0.6, 1.5}) {  // aside of the peak, where damping alone counts
        const double omega = share * natural;
        const RegularWave wave(kTwoPi / omega, 0.4, 1.0);
        const double k = omega * omega / kGravity_mps2;
        const double roll = std::abs(hull.respond({omega, 0.5 * kPi, 0.0}, 2.0).atGravity[3]) / k;
        EXPECT_NEAR(adrift(vessel, wave, wave.wavesTo_rad + 0.5 * kPi, 120.0, true).roll, roll, 0.1 * roll)
            << share;
    }
}

/// In calm water she must do what her manoeuvring model says: what it owns for slow motions is not there a
/// second time in the tables. What differs is the memory of the beginning of the turn.
struct TurningShip {
    const char* vessel;
    double speed_mps, shaft_rps;
};
class CalmTurn : public ::testing::TestWithParam<TurningShip> {};
TEST_P(CalmTurn, IsThatOfTheManoeuvringModel) {
    const Vessel vessel = shipped(GetParam().vessel);
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    Actuators actuators;
    actuators.shaft_rps.fill(GetParam().shaft_rps);
    ShipMotion model;
    model.surge_mps = GetParam().speed_mps;
    MovingShip atSea{model, {}};
    const double L = vessel.hull.lengthBp_m, step_s = 0.04;
    double worst_m = 0.0;
    for (double t = 0.0; t < 20.0 * L / GetParam().speed_mps; t += step_s) {
        actuators.rudder_rad = std::min(20.0 * kDegree_rad, vessel.steering.rate_radps * t);
        model = rk4Step(model, step_s,
                        [&](const ShipMotion& x) { return ship.derivative(x, actuators, {}, {}); });
        atSea = rk4Step(atSea, step_s,
                        [&](const MovingShip& x) { return ship.derivative(x, actuators, {}, {}, {}); });
        worst_m = std::max(worst_m, distance(model.position(), atSea.motion.position()));
    }
    EXPECT_GT(std::abs(model.heading_rad), 1.5);
    EXPECT_LT(worst_m, 0.01 * L);
    EXPECT_NEAR(atSea.motion.yawRate_radps, model.yawRate_radps, 0.005 * std::abs(model.yawRate_radps));
}
INSTANTIATE_TEST_SUITE_P(Shipped, CalmTurn,
                         ::testing::Values(TurningShip{"kvlcc2", 7.973889, 1.778511},
                                           TurningShip{"mariner", 7.7175, 1.3},
                                           TurningShip{"esso-osaka", 5.1, 0.85},
                                           TurningShip{"patrol51", 8.0, 7.0}),
                         [](const auto& row) {
                             std::string name = row.param.vessel;
                             std::erase(name, '-');
                             return name;
                         });

/// Amplitudes of free roll one after the other and the damping ratio between them.
struct RollSwing {
    double amplitude_deg, ratio;
};
std::vector<RollSwing> rollSwings(const Vessel& vessel, double start_deg, double end_deg) {
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    constexpr double kStep_s = 0.05;
    MovingShip m;
    m.motion.roll_rad = start_deg * kDegree_rad;
    const WaveEffect calm;
    std::vector<RollSwing> swings;
    double extreme_deg = start_deg;
    while (extreme_deg > end_deg) {
        const double before = m.motion.rollRate_radps;
        m = rk4Step(m, kStep_s, [&](const MovingShip& x) { return ship.derivative(x, {}, {}, calm, {}); });
        if (before == 0.0 || before * m.motion.rollRate_radps > 0.0) continue;
        const double now_deg = std::abs(m.motion.roll_rad) / kDegree_rad;
        swings.push_back({0.5 * (extreme_deg + now_deg), std::log(extreme_deg / now_deg) / kPi});
        extreme_deg = now_deg;
    }
    return swings;
}

TEST(SeaMotion, Kvlcc2RollsAsMeasuredWhenLeftToHerself) {
    const std::vector<RollSwing> swings = rollSwings(shipped("kvlcc2"), 12.0, 4.5);
    double worst = 0.0;
    for (const test::Row& row : test::readReference("seakeeping/kvlcc2_roll_decay_0kn.csv")) {
        const auto at = std::find_if(swings.begin(), swings.end(),
                                     [&](const RollSwing& s) { return s.amplitude_deg <= row["roll_abs"]; });
        ASSERT_NE(at, swings.end());
        // Issue 5, section 6; single swings scatter, the file's smoothed column is the mean of nine.
        EXPECT_NEAR(at->ratio, row["zeta_smooth"], 0.4 * row["zeta_smooth"]) << row["roll_abs"];
        worst = std::max(worst, std::abs(at->ratio / row["zeta_smooth"] - 1.0));
    }
    std::printf("damping ratio at most %.0f %% from the measured\n", 100.0 * worst);
}

TEST(SeaMotion, ATurnHeelsHer) {
    for (const char* id : {"esso-osaka", "mariner"}) {
        const Vessel vessel = shipped(id);
        const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
        MovingShip m;
        m.motion.surge_mps = 7.0;
        Actuators actuators;
        actuators.shaft_rps.fill(1.0);
        actuators.rudder_rad = 0.35;
        for (int i = 0; i < 8000; ++i)
            m = rk4Step(m, 0.04,
                        [&](const MovingShip& x) { return ship.derivative(x, actuators, {}, {}, {}); });
        EXPECT_GT(m.motion.yawRate_radps, 0.0);
        EXPECT_LT(m.motion.roll_rad, -0.01 * kDegree_rad) << id;  // outward: to port in a turn to starboard
        EXPECT_GT(m.motion.roll_rad, -10.0 * kDegree_rad) << id;
    }
}

TEST(WaveEffect, MirrorsBetweenThePortAndTheStarboardSide) {
    const Vessel vessel = shipped("patrol51");
    const RegularWave wave(8.0, 0.4, 0.5);
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    const auto waves = wave.at(31.0);
    const WaveForces a = ship.wavesAt(*waves, moving({}, wave.wavesTo_rad + 0.7, 5.0), 1.0).forces;
    const WaveForces b = ship.wavesAt(*waves, moving({}, wave.wavesTo_rad - 0.7, 5.0), 1.0).forces;
    for (const std::size_t i : {0U, 2U, 4U}) EXPECT_NEAR(a.first[i], b.first[i], 1e-6 * std::abs(a.first[i]));
    for (const std::size_t i : {1U, 3U, 5U})
        EXPECT_NEAR(a.first[i], -b.first[i], 1e-6 * std::abs(a.first[i]));
    EXPECT_NEAR(a.mean[1], -b.mean[1], 1e-6 * std::abs(a.mean[1]));
    EXPECT_NEAR(a.waterSway_mps, -b.waterSway_mps, 1e-9);
    EXPECT_NEAR(a.waterSurge_mps, b.waterSurge_mps, 1e-9);
}

TEST(WaveEffect, ShelterScalesForcesAndItsSquareTheMeanOnes) {
    const Vessel vessel = shipped("patrol51");
    const RegularWave wave(8.0, 0.4, 0.5);
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    const auto waves = wave.at(31.0);
    const WaveForces open = ship.wavesAt(*waves, moving({10, 20}, 1.0, 0.0), 1.0).forces;
    const WaveForces lee = ship.wavesAt(*waves, moving({10, 20}, 1.0, 0.0), 0.25).forces;
    EXPECT_DOUBLE_EQ(lee.first[2], 0.25 * open.first[2]);
    EXPECT_DOUBLE_EQ(lee.mean[0], 0.0625 * open.mean[0]);
    EXPECT_DOUBLE_EQ(lee.waterSway_mps, 0.25 * open.waterSway_mps);
}

/// In a head sea she is slowed, in a beam sea pushed to leeward.
TEST(WaveEffect, MeanForcesGoWithTheWaves) {
    const Vessel vessel = shipped("kvlcc2");
    const RegularWave wave(9.0, 0.0, 1.0);
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    const auto waves = wave.at(0.0);
    EXPECT_LT(ship.wavesAt(*waves, moving({}, kPi, 7.0), 1.0).forces.mean[0], 0.0);
    EXPECT_GT(ship.wavesAt(*waves, moving({}, -0.5 * kPi, 0.0), 1.0).forces.mean[1], 0.0);
}

}  // namespace
}  // namespace sagara::core
