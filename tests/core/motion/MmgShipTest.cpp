// The MMG standard method against the published ship it was introduced with.
#include "core/motion/MmgShip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
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
    const WaveTable waves{1, 1e6};
    const ShipDynamics ship{vessel, waves};
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
                             [&](const ShipMotion& m) { return ship.derivative(m, actuators, {}, {}, {}); });
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

}  // namespace
}  // namespace sagara::core
