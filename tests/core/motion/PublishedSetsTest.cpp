#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Vessel shipped(const std::string& id) {
    return loadVessel(id + ".json", test::readAsset("vessels/" + id + ".json")).value();
}

/// Ship and rudder as one state: the reference runs integrate the rudder law with the motion.
struct Steered {
    ShipMotion motion;
    double rudder_rad = 0.0;
};
Steered operator+(const Steered& a, const Steered& b) {
    return {a.motion + b.motion, a.rudder_rad + b.rudder_rad};
}
Steered operator*(double s, const Steered& a) { return {s * a.motion, s * a.rudder_rad}; }

struct TracedRun {
    const char* file;
    const char* vessel;
    double shaft_rps;
    double order_deg;
    double switch_deg;  ///< of a zigzag; 0: a turn
    double depth_m;
    double step_s;
};
const TracedRun kRuns[] = {
    {"mariner_turn_15", "mariner", 1.12383, 15.0, 0.0, kDeepWater_m, 0.05},
    {"mariner_turn_35", "mariner", 1.12383, 35.0, 0.0, kDeepWater_m, 0.05},
    {"mariner_z20", "mariner", 1.12383, 20.0, 20.0, kDeepWater_m, 0.05},
    {"container_turn_5", "sr108", 70.0 / 60.0, 5.0, 0.0, kDeepWater_m, 0.05},
    {"tanker190k_turn_m10_hT1083", "tanker190k", 80.0 / 60.0, -10.0, 0.0, 200.0, 0.1},
    {"tanker190k_turn_m10_hT150", "tanker190k", 80.0 / 60.0, -10.0, 0.0, 1.5 * 18.46, 0.1},
};

class PublishedSet : public ::testing::TestWithParam<TracedRun> {};
TEST_P(PublishedSet, FollowsItsComputedTrace) {
    const TracedRun& run = GetParam();
    const Vessel vessel = shipped(run.vessel);
    const ShipDynamics ship(vessel);
    const std::vector<test::Row> rows = test::readReference(std::string("manoeuvring/") + run.file + ".csv");
    Steered s;
    s.motion.surge_mps = rows[0]["u"];
    double order_rad = run.order_deg * kDegree_rad;
    const auto rate = [&](const Steered& x) {
        Actuators actuators;
        actuators.rudder_rad = x.rudder_rad;
        actuators.shaft_rps.fill(run.shaft_rps);
        const double most = vessel.steering.rate_radps;
        return Steered{ship.derivative(x.motion, actuators, {}, {}, run.depth_m),
                       std::clamp((order_rad - x.rudder_rad) / vessel.steering.lag_s, -most, most)};
    };
    const double L = vessel.hull.lengthBp_m;
    double worst_L = 0.0, worst_deg = 0.0, worstSpeed = 0.0, worstRoll_deg = 0.0, time_s = 0.0;
    for (const test::Row& row : rows) {
        for (; time_s < row["t"] - run.step_s / 2; time_s += run.step_s) {
            s = rk4Step(s, run.step_s, rate);
            const double turned_deg = s.motion.heading_rad / kDegree_rad;
            if (run.switch_deg > 0.0 && std::copysign(1.0, order_rad) * turned_deg >= run.switch_deg)
                order_rad = -order_rad;
        }
        worst_L = std::max(worst_L, distance(s.motion.position(), {row["x"], row["y"]}) / L);
        worst_deg = std::max(worst_deg, std::abs(s.motion.heading_rad / kDegree_rad - row["psi"]));
        const double speed_mps = std::hypot(row["u"], row["v"]);
        worstSpeed = std::max(worstSpeed,
                              std::abs(std::hypot(s.motion.surge_mps, s.motion.sway_mps) / speed_mps - 1.0));
        if (std::string(run.vessel) == "sr108")
            worstRoll_deg = std::max(worstRoll_deg, std::abs(s.motion.roll_rad / kDegree_rad - row["phi"]));
    }
    // tolerance of the files: 0.2 % of L, 0.2 deg, 0.2 %
    EXPECT_LE(worst_L, 0.002);
    EXPECT_LE(worst_deg, 0.2);
    EXPECT_LE(worstSpeed, 0.002);
    EXPECT_LE(worstRoll_deg, 0.1);
}
INSTANTIATE_TEST_SUITE_P(Traces, PublishedSet, ::testing::ValuesIn(kRuns),
                         [](const auto& row) { return std::string(row.param.file); });

/// Where a set holds its model is the ship's whole truth, and the change to the other one has no step.
class HandingOver : public ::testing::TestWithParam<const char*> {
protected:
    const Vessel vessel = shipped(GetParam());
    const ShipDynamics ship{vessel};
    const HoldsIn holds = *vessel.models[0].holds;

    static ShipMotion at(double surge_mps) {
        ShipMotion m;
        m.surge_mps = surge_mps;
        m.sway_mps = -0.3;
        m.yawRate_radps = 0.005;
        m.roll_rad = 0.02;
        return m;
    }
    ShipMotion rate(double surge_mps, double shaft_rps) const {
        Actuators actuators;
        actuators.rudder_rad = 0.2;
        actuators.shaft_rps.fill(shaft_rps);
        return ship.derivative(at(surge_mps), actuators, {}, {});
    }
};

TEST_P(HandingOver, ThePublishedSetAloneRulesInItsRange) {
    const PolynomialShip set(std::get<PolynomialModel>(vessel.models[0].parameters), vessel);
    for (double u = holds.from_mps; u <= holds.to_mps; u += 0.25) {
        Actuators actuators;
        actuators.rudder_rad = 0.2;
        actuators.shaft_rps.fill(holds.shaftFrom_rps);
        const PlanarAcceleration a = set.acceleration(at(u), actuators, {});
        const ShipMotion whole = rate(u, holds.shaftFrom_rps);
        EXPECT_EQ(whole.surge_mps, a.surge_mps2) << u;
        EXPECT_EQ(whole.sway_mps, a.sway_mps2) << u;
        EXPECT_EQ(whole.yawRate_radps, a.yaw_radps2) << u;
    }
}

TEST_P(HandingOver, IsSmoothInSpeedAndInShaftSpeed) {
    const auto same = [](const ShipMotion& a, const ShipMotion& b, double where) {
        EXPECT_NEAR(a.surge_mps, b.surge_mps, 2e-3) << where;
        EXPECT_NEAR(a.sway_mps, b.sway_mps, 2e-3) << where;
        EXPECT_NEAR(a.yawRate_radps, b.yawRate_radps, 1e-4) << where;
    };
    const double step = 0.002;
    for (double u = -2.0; u < holds.nothingAbove_mps + 1.0; u += step)
        same(rate(u, 1.0), rate(u + step, 1.0), u);
    const double u = 0.5 * (holds.from_mps + holds.to_mps);
    for (double n = -0.9; n < 1.0; n += step)
        if (std::abs(n) > 2.0 * step) same(rate(u, n), rate(u, n + step), n);
}
INSTANTIATE_TEST_SUITE_P(Assets, HandingOver, ::testing::Values("mariner", "sr108", "tanker190k"));

TEST(DepthParameter, IsThePublishedOneAndHeldInTheShallowest) {
    const Vessel vessel = shipped("tanker190k");
    const PolynomialRows rows(std::get<PolynomialModel>(vessel.models[0].parameters), vessel);
    EXPECT_EQ(rows.depthParameter(kDeepWater_m), 0.0);
    EXPECT_NEAR(rows.depthParameter(1.5 * 18.46), 2.0, 1e-12);
    EXPECT_NEAR(rows.depthParameter(1.01 * 18.46), 5.0, 1e-9);
    EXPECT_NEAR(rows.depthParameter(-3.0), 5.0, 1e-9);
}

}  // namespace
}  // namespace sagara::core
