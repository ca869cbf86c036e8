#include "core/exercise/Forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "core/exercise/Session.h"
#include "core/exercise/TickLoads.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

/// What the motion of the next tick is made of, and what it comes to, but for waves: in a world that feels
/// none.
void expectTheWhole(const World& world, const State& state, std::size_t index) {
    const OwnShip& ship = *world.ships[index];
    const OwnShipState& s = state.ships[index];
    Actuators actuators;
    actuators.rudder_rad = s.steering.angle_rad;
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) actuators.shaft_rps[i] = s.shafts[i].speed_rps;
    const TickEnvironment environment(world, state);
    const TickLoads loads(world, state, index, environment, actuators);
    const Load total =
        ship.dynamics.forceFor(s.motion, loads.rate({s.motion, {}}, actuators).motion, loads.depth_m());

    const ShipForces forces = forcesOn(world, state, index);
    const Load sum = sumOf(forces);
    double largest_N = 1.0, largest_Nm = 1.0;
    for (const Load& f : forces) {
        largest_N = std::max({largest_N, std::abs(f.surge_N), std::abs(f.sway_N)});
        largest_Nm = std::max(largest_Nm, std::abs(f.yaw_Nm));
    }
    EXPECT_NEAR(sum.surge_N, total.surge_N, 1e-9 * largest_N);
    EXPECT_NEAR(sum.sway_N, total.sway_N, 1e-9 * largest_N);
    EXPECT_NEAR(sum.yaw_Nm, total.yaw_Nm, 1e-9 * largest_Nm);
}

TEST(Forces, TheirSumIsWhatTheMotionUsesAtTheBerthAndOnTheWay) {
    const auto world = test::lessonWorld();
    const auto still = buildWorld(world->documents, world->seed, WorldUse::Look).value();
    Session session(world, startState(*world, 3), {{0, 0, PilotOrder{true}}}, nullptr);
    bool lines = false;
    while (session.state().tick < 400 * kTicksPerSecond) {
        (void)session.step();
        if (session.state().tick % 250 != 0) continue;
        expectTheWhole(*still, session.state(), 0);
        const ShipForces f = forcesOn(*world, session.state(), 0);
        lines = lines || std::abs(of(f, ForceCause::Lines).sway_N) > 100.0;
        if (::testing::Test::HasFailure()) return;
    }
    EXPECT_TRUE(lines);
}

TEST(Forces, OfBothModelsInATurnInASeaway) {
    for (const char* vessel : {"patrol51", "esso-osaka"}) {
        std::string text = test::openWaterScenario(1, 0);
        text = test::with(text, "/ownShips/0/vessel", std::string("\"") + vessel + "\"");
        const auto world = test::worldOf(text);
        const auto still = buildWorld(world->documents, world->seed, WorldUse::Look).value();
        State state = startState(*world, 5);
        std::vector<Command> turn{{0, 0, HelmOrder{20.0 * kDegree_rad}}};
        for (int i = 0; i < 3000; ++i) {
            (void)advance(*world, state, turn);
            turn.clear();
            if (i % 100 == 0) expectTheWhole(*still, state, 0);
        }
        const ShipForces f = forcesOn(*world, state, 0);
        EXPECT_GT(of(f, ForceCause::Rudder).yaw_Nm, 0.0) << vessel;  // the bow to starboard
        EXPECT_GT(of(f, ForceCause::Propeller).surge_N, 0.0) << vessel;
        EXPECT_LT(of(f, ForceCause::Hull).surge_N, 0.0) << vessel;
        EXPECT_NE(of(f, ForceCause::Wind).sway_N, 0.0) << vessel;
        EXPECT_NE(of(f, ForceCause::Waves).surge_N, 0.0) << vessel;
        EXPECT_EQ(of(f, ForceCause::Lines).surge_N, 0.0) << vessel;
    }
}

}  // namespace
}  // namespace sagara::core
