// The MMG standard method against the published ship it was introduced with.
#include "core/motion/MmgShip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/motion/MmgShallow.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Vessel shipped(const std::string& id) {
    const auto vessel = loadVessel(id, test::readAsset("vessels/" + id + ".json"));
    if (!vessel) throw std::runtime_error(vessel.error().text());
    return *vessel;
}
MmgShip shipOf(const Vessel& vessel) {
    return {std::get<MmgModel>(vessel.models.front().parameters), vessel};
}

TEST(MmgForces, AreThoseOfThePublishedModelAtFixedStates) {
    const Vessel full = shipped("kvlcc2"), l7 = shipped("kvlcc2-l7");
    for (const test::Row& row : test::readReference("manoeuvring/kvlcc2_mmg_force_spots.csv")) {
        const Vessel& vessel = row.text("scale") == "full" ? full : l7;
        const MmgShip ship = shipOf(vessel);
        ShipMotion m;
        m.surge_mps = row["u"];
        m.sway_mps = row["v"];
        m.yawRate_radps = row["r"];
        const Actuators actuators{row["delta"] * kDegree_rad, {row["n"]}};
        const HullForces f = ship.hullForces(m, actuators);
        const MmgShip::Parts parts = ship.parts(m, actuators);
        const MmgPropeller& screw = parts.screws[0];
        const MmgRudderForce& rudder = parts.rudders[0];
        const PlanarAcceleration a = ship.acceleration(m, actuators, {});
        const PropulsionUnit& unit = vessel.propulsion.units[0];
        const double scale_N = std::abs(row["XH"]), L = vessel.hull.lengthBp_m;
        // tolerance of the file 1e-6; a hundredth of it for what is a difference of large forces
        const auto is = [&](double value, const char* column, double scale) {
            EXPECT_NEAR(value, row[column], 1e-6 * std::abs(row[column]) + 1e-8 * scale)
                << column << " " << row.text("scale") << " " << row.text("u");
        };
        is(f.hull.surge_N, "XH", scale_N);
        is(f.hull.sway_N, "YH", scale_N);
        is(f.hull.yaw_Nm, "NH", scale_N * L);
        is(f.propeller.surge_N, "XP", scale_N);
        is(f.rudder.surge_N, "XR", scale_N);
        is(f.rudder.sway_N, "YR", scale_N);
        is(f.rudder.yaw_Nm, "NR", scale_N * L);
        is(screw.inflow_mps / (row["n"] * unit.diameter_m), "J", 1.0);
        is(screw.thrust_N /
               (vessel.hull.waterDensity_kgpm3 * row["n"] * row["n"] * std::pow(unit.diameter_m, 4)),
           "KT", 1.0);
        is(screw.wake, "wP", 1.0);
        is(rudder.normal_N, "FN", scale_N);
        const double sway_mps2 = scale_N / vessel.hull.mass_kg();
        is(a.surge_mps2, "u_dot", sway_mps2);
        is(a.sway_mps2, "v_dot", sway_mps2);
        is(a.yaw_radps2, "r_dot", sway_mps2 / L);
    }
}

/// A reference run of kvlcc2_mmg_parameters.json: constant shaft speed, the rudder starts at time zero and
/// moves at its rate, which acts with its mean over the tick; the zigzag turns it at the heading itself.
struct ReferenceRun {
    const char* name;
    const char* file;
    const char* vessel;
    double speed_mps, shaft_rps, step_s;
    double rudder_deg;  ///< first order
    double switch_deg;  ///< 0: a turn
};

class MmgTrace : public ::testing::TestWithParam<ReferenceRun> {};

TEST_P(MmgTrace, IsThePublishedModels) {
    const ReferenceRun& run = GetParam();
    const Vessel vessel = shipped(run.vessel);
    const ShipDynamics ship(vessel);
    ShipMotion motion;
    motion.surge_mps = run.speed_mps;
    double rudder_rad = 0.0, time_s = 0.0, order_rad = run.rudder_deg * kDegree_rad;
    const double L = vessel.hull.lengthBp_m;
    double worstPlace_L = 0.0, worstHeading_deg = 0.0, worstSpeed = 0.0;
    for (const test::Row& row : test::readReference(std::string("manoeuvring/") + run.file)) {
        while (time_s < row["t"] - run.step_s / 2) {
            const double most = vessel.steering.rate_radps * run.step_s;
            const double next_rad = rudder_rad + std::clamp(order_rad - rudder_rad, -most, most);
            const Actuators actuators{0.5 * (rudder_rad + next_rad), {run.shaft_rps}};
            motion = rk4Step(motion, run.step_s,
                             [&](const ShipMotion& m) { return ship.derivative(m, actuators, {}, {}); });
            rudder_rad = next_rad;
            time_s += run.step_s;
            const double side = order_rad > 0.0 ? 1.0 : -1.0;
            if (run.switch_deg > 0.0 && side * motion.heading_rad >= run.switch_deg * kDegree_rad)
                order_rad = -order_rad;
        }
        worstPlace_L = std::max(worstPlace_L, distance(motion.position(), {row["x"], row["y"]}) / L);
        worstHeading_deg =
            std::max(worstHeading_deg, std::abs(motion.heading_rad / kDegree_rad - row["psi"]));
        const double speed_mps = std::hypot(row["u"], row["v"]);
        worstSpeed =
            std::max(worstSpeed, std::abs(std::hypot(motion.surge_mps, motion.sway_mps) / speed_mps - 1.0));
    }
    RecordProperty("worstPlace_L", std::to_string(worstPlace_L));
    // 0.2 % of L, 0.1 deg, 0.1 % of speed: the file's tolerance
    EXPECT_LE(worstPlace_L, 0.002);
    EXPECT_LE(worstHeading_deg, 0.1);
    EXPECT_LE(worstSpeed, 0.001);
}

constexpr double kFull_mps = 7.973888888888889, kFull_rps = 1.778510597, kL7_mps = 1.179,
                 kL7_rps = 11.851590316;
INSTANTIATE_TEST_SUITE_P(Kvlcc2, MmgTrace,
                         ::testing::Values(ReferenceRun{"fullTurn", "kvlcc2_mmg_full_turn_p35.csv", "kvlcc2",
                                                        kFull_mps, kFull_rps, 0.05, 35.0, 0.0},
                                           ReferenceRun{"fullZigzag10", "kvlcc2_mmg_full_zz_10_10_s.csv",
                                                        "kvlcc2", kFull_mps, kFull_rps, 0.02, 10.0, 10.0},
                                           ReferenceRun{"fullZigzag20", "kvlcc2_mmg_full_zz_20_20_p.csv",
                                                        "kvlcc2", kFull_mps, kFull_rps, 0.02, -20.0, 20.0},
                                           ReferenceRun{"modelTurn", "kvlcc2_mmg_L7_turn_p35.csv",
                                                        "kvlcc2-l7", kL7_mps, kL7_rps, 0.01, 35.0, 0.0},
                                           ReferenceRun{"modelZigzag20", "kvlcc2_mmg_L7_zz_20_20_s.csv",
                                                        "kvlcc2-l7", kL7_mps, kL7_rps, 0.005, 20.0, 20.0}),
                         [](const auto& row) { return row.param.name; });

// --- beyond the published range ---

ShipMotion moving(double surge_mps, double sway_mps, double yawRate_radps) {
    ShipMotion m;
    m.surge_mps = surge_mps;
    m.sway_mps = sway_mps;
    m.yawRate_radps = yawRate_radps;
    return m;
}

TEST(MmgRange, CrossFlowHasExactlyNoShareInThePublishedRange) {
    Vessel vessel = shipped("kvlcc2");
    const MmgShip ship = shipOf(vessel);
    std::get<MmgModel>(vessel.models.front().parameters).parameters.range.crossFlowDrag = 3.0;
    const MmgShip other = shipOf(vessel);
    for (const double drift_deg : {0.0, 10.0, -20.0, 29.0}) {
        for (const double yawRate : {0.0, 0.6, -1.1}) {
            const double U = 4.0;
            const ShipMotion m = moving(U * std::cos(drift_deg * kDegree_rad),
                                        -U * std::sin(drift_deg * kDegree_rad), yawRate * U / 320.0);
            const Load a = ship.hullForces(m, {}).hull, b = other.hullForces(m, {}).hull;
            EXPECT_EQ(a.sway_N, b.sway_N);
            EXPECT_EQ(a.yaw_Nm, b.yaw_Nm);
        }
    }
}

TEST(MmgRange, ForcesGoToZeroWithTheSpeedInEveryDirection) {
    const Vessel vessel = shipped("kvlcc2");
    const MmgShip ship = shipOf(vessel);
    const Load still = ship.hullForces({}, {}).hull;
    EXPECT_EQ(still.surge_N, 0.0);
    EXPECT_EQ(still.sway_N, 0.0);
    EXPECT_EQ(still.yaw_Nm, 0.0);
    for (int i = 0; i < 36; ++i) {
        const double a = 10.0 * i * kDegree_rad;
        for (const double turning : {-3.0, 0.0, 1.5}) {
            const auto at = [&](double U) {
                return ship.hullForces(moving(U * std::cos(a), U * std::sin(a), turning * U / 320.0),
                                       {0.5, {}});
            };
            const HullForces one = at(1.0), small = at(1e-4);
            // all of second order in the velocities
            EXPECT_NEAR(small.hull.sway_N, 1e-8 * one.hull.sway_N, 1e-12 * std::abs(one.hull.sway_N) + 1e-9);
            EXPECT_NEAR(small.rudder.yaw_Nm, 1e-8 * one.rudder.yaw_Nm,
                        1e-12 * std::abs(one.rudder.yaw_Nm) + 1e-9);
        }
    }
}

TEST(MmgRange, HullResistsDriftAndSwingInEveryDirection) {
    const Vessel vessel = shipped("kvlcc2");
    const MmgShip ship = shipOf(vessel);
    for (int i = 0; i <= 36; ++i) {
        const double a = 10.0 * i * kDegree_rad, U = 1.5;
        const ShipMotion m = moving(U * std::cos(a), U * std::sin(a), 0.0);
        const Load f = ship.hullForces(m, {}).hull;
        EXPECT_LT(f.surge_N * m.surge_mps + f.sway_N * m.sway_mps, 0.0) << 10 * i;  // takes energy
    }
    for (const double r : {-0.01, -0.002, 0.002, 0.01})
        EXPECT_LT(ship.hullForces(moving(0.0, 0.0, r), {}).hull.yaw_Nm * r, 0.0);
}

TEST(MmgRange, ForcesAreContinuousRoundTheCompassAndFromAheadToAstern) {
    const Vessel vessel = shipped("kvlcc2");
    const MmgShip ship = shipOf(vessel);
    for (const double shaft_rps : {-1.0, 0.0, 1.0}) {
        HullForces before;
        for (int i = 0; i <= 7200; ++i) {
            const double a = 0.05 * i * kDegree_rad;
            const HullForces f =
                ship.hullForces(moving(2.0 * std::cos(a), 2.0 * std::sin(a), 0.002), {0.4, {shaft_rps}});
            if (i > 0) {
                EXPECT_NEAR(f.hull.sway_N, before.hull.sway_N, 2e5) << a;
                EXPECT_NEAR(f.rudder.sway_N, before.rudder.sway_N, 2e4) << a << " " << shaft_rps;
                EXPECT_NEAR(f.propeller.surge_N, before.propeller.surge_N, 3e4) << a;
            }
            before = f;
        }
    }
}

TEST(MmgRudder, KicksFromRestAndActsTheOtherWayWithSternway) {
    const Vessel vessel = shipped("kvlcc2");
    const MmgShip ship = shipOf(vessel);
    const double helm_rad = 20.0 * kDegree_rad;
    EXPECT_GT(ship.hullForces({}, {helm_rad, {1.0}}).rudder.yaw_Nm, 1e7);
    EXPECT_EQ(ship.hullForces({}, {helm_rad, {0.0}}).rudder.yaw_Nm, 0.0);
    EXPECT_GT(ship.hullForces(moving(3.0, 0.0, 0.0), {helm_rad, {0.0}}).rudder.yaw_Nm, 0.0);
    EXPECT_LT(ship.hullForces(moving(-3.0, 0.0, 0.0), {helm_rad, {0.0}}).rudder.yaw_Nm, 0.0);
    // engine astern with headway: the rudder loses much of what it does
    const double coasting = ship.hullForces(moving(4.0, 0.0, 0.0), {helm_rad, {0.0}}).rudder.yaw_Nm;
    const double backing = ship.hullForces(moving(4.0, 0.0, 0.0), {helm_rad, {-1.0}}).rudder.yaw_Nm;
    EXPECT_LT(std::abs(backing), 0.6 * coasting);
}

/// KVLCC2 with two screws and two rudders of half the disc and area, abreast.
Vessel twinScrew() {
    Vessel v = shipped("kvlcc2");
    PropulsionUnit unit = v.propulsion.units[0];
    unit.diameter_m /= std::sqrt(2.0);
    unit.position.y_m = -12.0;
    v.propulsion.units = {unit, unit};
    v.propulsion.units[1].position.y_m = 12.0;
    v.steering.areaEach_m2 /= 2.0;
    v.steering.rudders = {{-160.0, -12.0}, {-160.0, 12.0}};
    MmgParameters& p = std::get<MmgModel>(v.models.front().parameters).parameters;
    p.rudder.height_m /= std::sqrt(2.0);
    return v;
}

TEST(MmgTwinScrew, MirrorsPortAndStarboard) {
    const Vessel vessel = twinScrew();
    const MmgShip ship = shipOf(vessel);
    const PlanarAcceleration a = ship.acceleration(moving(5.0, -0.8, 0.006), {0.3, {1.8, 2.4}}, {});
    const PlanarAcceleration b = ship.acceleration(moving(5.0, 0.8, -0.006), {-0.3, {2.4, 1.8}}, {});
    EXPECT_NEAR(a.surge_mps2, b.surge_mps2, 1e-12);
    EXPECT_NEAR(a.sway_mps2, -b.sway_mps2, 1e-12);
    EXPECT_NEAR(a.yaw_radps2, -b.yaw_radps2, 1e-14);
    EXPECT_NEAR(a.heel_Nm, -b.heel_Nm, 1e-3);
}

TEST(MmgTwinScrew, TurnsOnTheSpotAndMeetsTheTurnWithEachScrewByItself) {
    const Vessel vessel = twinScrew();
    const MmgShip ship = shipOf(vessel);
    EXPECT_GT(ship.acceleration({}, {0.0, {1.0, -1.2}}, {}).yaw_radps2, 0.0);  // port ahead: to starboard
    // turning to starboard the port screw is outside and meets the faster water
    const MmgShip::Parts parts = ship.parts(moving(5.0, 0.0, 0.01), {0.0, {2.0, 2.0}});
    EXPECT_GT(parts.screws[0].inflow_mps, parts.screws[1].inflow_mps);
    EXPECT_LT(parts.screws[0].thrust_N, parts.screws[1].thrust_N);
}

// --- roll ---

/// KCS, 2.19 m model: Yasukawa, Sakuno and Yoshimura (2019) as in kcs_mmg4dof_coefficients.json, a secondary
/// transcription: for trends.
Vessel kcs() {
    Vessel v = shipped("kvlcc2-l7");
    v.hull.stations.clear();
    v.hull.lengthBp_m = 2.1905;
    v.hull.beam_m = 0.3067;
    v.hull.draught_m = 0.1029;
    v.hull.displacement_m3 = 0.0449;
    v.hull.waterplaneCoefficient = 0.82;
    v.hull.metacentricHeight_m = 0.008;
    v.hull.rollGyradius_m = 0.0767;
    PropulsionUnit& unit = v.propulsion.units[0];
    unit.position.x_m = -0.48 * 2.1905;
    unit.diameter_m = 0.0756;
    unit.thrustCoefficients = {0.50278, -0.29546, -0.18095};
    unit.wakeFraction = 0.353;
    unit.thrustDeduction = 0.178;
    v.steering.areaEach_m2 = 0.00421;
    v.steering.rudders = {{-0.5 * 2.1905, 0.0}};
    MmgParameters& p = std::get<MmgModel>(v.models.front().parameters).parameters;
    p.inertia = {-0.03242, 0.25 * 2.1905, 0.0061, 0.1521, 0.0089};
    p.hull = {};
    p.hull.R0 = 0.0183;
    p.hull.Xvv = -0.0603, p.hull.Xrr = -0.0162, p.hull.Xvvvv = -0.076, p.hull.Xrphi = 0.0258;
    p.hull.Yv = -0.2162, p.hull.Yr = 0.0245 + 0.0061;  // given as Yr - mx
    p.hull.Yvvv = -1.7028, p.hull.Yvvr = -0.5658, p.hull.Yvrr = -0.8564, p.hull.Yrrr = -0.0105;
    p.hull.Nv = -0.1172, p.hull.Nr = -0.0443;
    p.hull.Nvvv = -0.171, p.hull.Nvvr = -0.5602, p.hull.Nvrr = -0.02, p.hull.Nrrr = -0.0369;
    p.hull.Yphi = -0.0052, p.hull.Yvvphi = 0.3352, p.hull.Yvrphi = -0.3123, p.hull.Yrrphi = -0.0642;
    p.hull.Nphi = -0.0063, p.hull.Nvvphi = -0.2532, p.hull.Nvrphi = -0.1152, p.hull.Nrrphi = -0.012;
    p.wake.C1 = 0.0;
    p.rudder = {0.0756 / 0.792, 3.0081, 0.441, 0.232, -0.711, -0.774, 0.412, 0.412, 0.9, 0.713};
    return v;
}

TEST(MmgRoll, HeelsOutwardInTheTurnAndTurnsAwayFromTheLowSide) {
    const Vessel vessel = kcs();
    const MmgShip ship = shipOf(vessel);
    EXPECT_LT(ship.acceleration(moving(0.8, -0.1, 0.15), {0.6, {10.0}}, {}).heel_Nm, 0.0);  // to port
    ShipMotion m = moving(1.0, 0.0, 0.0);
    m.roll_rad = 0.1;  // starboard side down
    EXPECT_LT(ship.hullForces(m, {}).hull.yaw_Nm, 0.0);
}

TEST(MmgRoll, MirrorsPortAndStarboardWithTheRoll) {
    const Vessel vessel = kcs();
    const MmgShip ship = shipOf(vessel);
    ShipMotion m = moving(0.8, -0.15, 0.2), mirror = moving(0.8, 0.15, -0.2);
    m.roll_rad = -0.1;
    mirror.roll_rad = 0.1;
    const PlanarAcceleration a = ship.acceleration(m, {0.4, {12.0}}, {}),
                             b = ship.acceleration(mirror, {-0.4, {12.0}}, {});
    EXPECT_NEAR(a.surge_mps2, b.surge_mps2, 1e-12);
    EXPECT_NEAR(a.sway_mps2, -b.sway_mps2, 1e-12);
    EXPECT_NEAR(a.yaw_radps2, -b.yaw_radps2, 1e-12);
}

// --- depth ---

TEST(MmgShallow, FactorsAreThePublishedRegressions) {
    for (const test::Row& row : test::readReference("environment/shallow_water_factors_check.csv")) {
        Hull hull;
        hull.lengthBp_m = row["L"];
        hull.beam_m = row["B"];
        hull.draught_m = row["d"];
        hull.displacement_m3 = row["Cb"] * row["L"] * row["B"] * row["d"];
        const ShallowFactors f = shallowFactors(hull, row["h_over_d"] * row["d"]);
        const std::pair<const char*, double> factors[] = {{"Yb_factor", f.Yv},
                                                          {"Nb_factor", f.Nv},
                                                          {"my_factor", f.my},
                                                          {"Jz_factor", f.Jz},
                                                          {"mx_factor", f.mx}};
        // as printed: six figures, trailing zeros left out
        for (const auto& [column, value] : factors) EXPECT_NEAR(value / row[column], 1.0, 5e-6) << column;
    }
}

TEST(MmgShallow, DeepWaterIsExactlyThePublishedModelAndVeryDeepNearlyIt) {
    const Vessel vessel = shipped("kvlcc2");
    const MmgShip ship = shipOf(vessel);
    const ShipMotion m = moving(6.0, -1.0, 0.008);
    const Actuators actuators{0.5, {1.7}};
    EXPECT_EQ(ship.acceleration(m, actuators, {}, kDeepWater_m).yaw_radps2,
              ship.acceleration(m, actuators, {}).yaw_radps2);
    const double deep = ship.acceleration(m, actuators, {}).yaw_radps2;
    EXPECT_NEAR(ship.acceleration(m, actuators, {}, 1e5).yaw_radps2 / deep, 1.0, 0.01);
}

/// Tactical diameter at 35 deg of rudder from a speed whose shaft speed is held, over the length.
struct Turn {
    double advance_L = 0.0, tacticalDiameter_L = 0.0, yawRate = 0.0, drift_deg = 0.0, diameter_L = 0.0;
};
Turn hardOver(const Vessel& vessel, double speed_mps, double depth_m) {
    const ShipDynamics ship(vessel);
    const double L = vessel.hull.lengthBp_m, step_s = 0.0005 * L;
    double slow_rps = 0.0, fast_rps = 40.0;  // of the shaft that holds the speed
    for (int i = 0; i < 50; ++i) {
        const double n = 0.5 * (slow_rps + fast_rps);
        const ShipMotion rate = ship.derivative(moving(speed_mps, 0.0, 0.0), {0.0, {n}}, {}, {}, depth_m);
        (rate.surge_mps < 0.0 ? slow_rps : fast_rps) = n;
    }
    ShipMotion m = moving(speed_mps, 0.0, 0.0);
    Turn turn;
    double rudder_rad = 0.0;
    while (m.heading_rad < 3.0 * kPi) {
        rudder_rad = std::min(35.0 * kDegree_rad, rudder_rad + vessel.steering.rate_radps * step_s);
        m = rk4Step(m, step_s, [&](const ShipMotion& x) {
            return ship.derivative(x, {rudder_rad, {fast_rps}}, {}, {}, depth_m);
        });
        if (m.heading_rad < 0.5 * kPi) turn.advance_L = m.north_m / L;
        if (m.heading_rad < kPi) turn.tacticalDiameter_L = m.east_m / L;
    }
    const double U = std::hypot(m.surge_mps, m.sway_mps);
    turn.yawRate = m.yawRate_radps * L / U;
    turn.drift_deg = std::atan2(-m.sway_mps, m.surge_mps) / kDegree_rad;
    turn.diameter_L = 2.0 / turn.yawRate;
    return turn;
}

TEST(MmgRoll, ATurnWithHeelIsTighterThanAStiffShips) {
    Vessel tender = kcs(), stiff = tender;
    stiff.hull.metacentricHeight_m = 0.08;
    const Turn heeled = hardOver(tender, 1.1, kDeepWater_m), upright = hardOver(stiff, 1.1, kDeepWater_m);
    EXPECT_LT(heeled.tacticalDiameter_L, upright.tacticalDiameter_L);
    EXPECT_GT(heeled.tacticalDiameter_L, 2.0);
    EXPECT_LT(upright.tacticalDiameter_L, 4.5);
}

TEST(EssoOsaka, TurnsAsInHerTrialsInDeepAndShallowWater) {
    const Vessel vessel = shipped("esso-osaka");
    const double T = vessel.hull.draught_m, speed_mps = 10.0 * kKnot_mps;
    const Turn deep = hardOver(vessel, speed_mps, kDeepWater_m),
               medium = hardOver(vessel, speed_mps, 1.5 * T), shallow = hardOver(vessel, speed_mps, 1.2 * T);
    std::printf("advance %.0f m, tactical diameter %.0f m; ratios %.3f at h/T 1.5, %.3f at 1.2\n",
                325.0 * deep.advance_L, 325.0 * deep.tacticalDiameter_L,
                medium.tacticalDiameter_L / deep.tacticalDiameter_L,
                shallow.tacticalDiameter_L / deep.tacticalDiameter_L);
    // trials of 1977, recalled: the aim of issue 5 is 10 %
    EXPECT_NEAR(325.0 * deep.advance_L / 1015.0, 1.0, 0.10);
    EXPECT_NEAR(325.0 * deep.tacticalDiameter_L / 925.0, 1.0, 0.10);
    // "grows little from deep to h/T 1.5 (1.1, 15 %) and by up to about 75 % at 1.2"; issue 5: 1.5 to 2.0
    EXPECT_NEAR(medium.tacticalDiameter_L / deep.tacticalDiameter_L / 1.1, 1.0, 0.15);
    EXPECT_GT(shallow.tacticalDiameter_L / deep.tacticalDiameter_L, 1.5);
    EXPECT_LT(shallow.tacticalDiameter_L / deep.tacticalDiameter_L, 2.0);
    // "speed loss and drift angle in the turn shrink as the water gets shallower"
    EXPECT_LT(shallow.drift_deg, medium.drift_deg);
    EXPECT_LT(medium.drift_deg, deep.drift_deg);
}

/// The 3 m model: the ship by scale, with the model's own resistance, propeller and wake.
TEST(EssoOsaka, ThreeMetreModelTurnsAsInThePond) {
    Vessel v = shipped("esso-osaka");
    const double scale = 3.0 / 325.0;
    v.hull.lengthBp_m = 3.0;
    v.hull.beam_m = 0.48925;
    v.hull.draught_m = 0.20114;
    v.hull.displacement_m3 = 0.2451;
    v.hull.waterDensity_kgpm3 = 998.0;
    v.hull.metacentricHeight_m *= scale;
    v.hull.rollGyradius_m *= scale;
    PropulsionUnit& unit = v.propulsion.units[0];
    unit.position.x_m *= scale;
    unit.diameter_m = 0.084;
    unit.thrustCoefficients = {0.3278, -0.3323, -0.156};
    unit.wakeFraction = 0.614;
    v.steering.rudders = {{-1.5, 0.0}};
    v.steering.areaEach_m2 = 0.01063;
    v.steering.rate_radps = 20.0 * kDegree_rad;
    MmgParameters& p = std::get<MmgModel>(v.models.front().parameters).parameters;
    p.inertia.xG_m = 0.0936;
    p.inertia.yawGyradius_m = 0.75;
    p.hull.R0 = 0.02139;
    p.rudder.height_m = 0.128;
    const Turn turn = hardOver(v, 0.45, kDeepWater_m);
    double yawRate = 0.0, drift_deg = 0.0, diameter_L = 0.0, runs = 0.0;
    for (const test::Row& row : test::readReference("manoeuvring/esso_osaka_model3m_steady_turns.csv")) {
        yawRate += row["r_prime"];
        drift_deg += row["beta_deg"];
        diameter_L += row["D_over_L"];
        runs += 1.0;
    }
    std::printf("r' %.3f (%.3f), drift %.1f (%.1f) deg, diameter %.3f (%.3f) L\n", turn.yawRate,
                yawRate / runs, turn.drift_deg, drift_deg / runs, turn.diameter_L, diameter_L / runs);
    EXPECT_NEAR(turn.yawRate / (yawRate / runs), 1.0, 0.12);  // tolerances of the file
    EXPECT_NEAR(turn.diameter_L / (diameter_L / runs), 1.0, 0.12);
    EXPECT_NEAR(turn.drift_deg, drift_deg / runs, 4.0);
}

}  // namespace
}  // namespace sagara::core
