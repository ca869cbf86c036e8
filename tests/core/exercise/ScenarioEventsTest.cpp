#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

/// The lesson with one event of its own.
std::shared_ptr<const World> worldWith(const std::string& when, const std::string& order) {
    return test::worldOf(test::lessonWith("/events", "[{\"id\": \"e\", \"title\": \"E\", \"when\": " + when +
                                                         ", \"orders\": [" + order + "]}]"));
}

bool happened(const std::vector<Event>& events, EventKind kind) {
    return std::any_of(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; });
}

/// All events of so many seconds.
std::vector<Event> run(const World& world, State& state, double seconds, std::vector<Command> commands = {}) {
    std::vector<Event> all;
    const auto end = state.tick + static_cast<std::int64_t>(seconds * kTicksPerSecond);
    while (state.tick < end) {
        const auto now = advance(world, state, commands);
        commands.clear();
        all.insert(all.end(), now.begin(), now.end());
    }
    return all;
}

TEST(ScenarioEvents, ByTimeHappensOnceAtItsSecond) {
    const auto world = worldWith(R"({"time_s": 5})", R"({"order": "fault", "fault": "steeringJam"})");
    State state = startState(*world, 1);
    EXPECT_TRUE(run(*world, state, 4.9).empty());
    EXPECT_TRUE(happened(run(*world, state, 0.2), EventKind::ScenarioEvent));
    EXPECT_TRUE(state.ships[0].steering.jammed);
    EXPECT_FALSE(happened(run(*world, state, 10.0), EventKind::ScenarioEvent));
}

TEST(ScenarioEvents, ByZoneHappensWhenTheShipIsThere) {
    const auto near =
        worldWith(R"({"near": "new_pier", "within_M": 0.05})", R"({"order": "difficulty", "level": 2})");
    State state = startState(*near, 1);
    EXPECT_TRUE(happened(run(*near, state, 0.1), EventKind::LevelChanged));
    const auto far = worldWith(R"({"near": "anch_ne_monsoon", "within_M": 0.05})",
                               R"({"order": "difficulty", "level": 2})");
    State other = startState(*far, 1);
    EXPECT_FALSE(happened(run(*far, other, 1.0), EventKind::LevelChanged));
}

TEST(ScenarioEvents, ByCommandHappensWhenTheTrainerSaysSo) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    EXPECT_FALSE(happened(run(*world, state, 1.0), EventKind::ScenarioEvent));
    EXPECT_TRUE(happened(run(*world, state, 1.0, {{0, 0, TriggerOrder{3}}}), EventKind::FaultCame));
    EXPECT_TRUE(state.ships[0].shafts[0].failed);
    EXPECT_FALSE(state.ships[0].shafts[1].failed);
}

TEST(ScenarioEvents, AFailedEngineStopsAndAMendedOneStartsAgain) {
    const auto world = test::worldOf(test::openWaterScenario(1, 0));
    State state = startState(*world, 1);
    (void)run(*world, state, 60.0, {{0, 0, FaultOrder{Fault::Engine, 0, false}}});
    EXPECT_EQ(state.ships[0].shafts[0].speed_rps, 0.0);
    EXPECT_GT(state.ships[0].shafts[1].speed_rps, 4.0);
    (void)run(*world, state, 30.0, {{0, 0, FaultOrder{Fault::Engine, 0, true}}});
    EXPECT_GT(state.ships[0].shafts[0].speed_rps, 4.0);
}

TEST(ScenarioEvents, OneSteeringPumpHalvesTheRateAndTwoHoldTheRudder) {
    const auto world = test::worldOf(test::openWaterScenario(1, 0));
    const auto angleAfter2s = [&](std::uint8_t pumps) {
        State state = startState(*world, 1);
        std::vector<Command> commands{{0, 0, HelmOrder{0.5}}};
        if (pumps > 0) commands.push_back({0, 0, FaultOrder{Fault::SteeringPump, pumps, false}});
        (void)run(*world, state, 2.0, commands);
        return state.ships[0].steering.angle_rad / kDegree_rad;
    };
    EXPECT_NEAR(angleAfter2s(0), 16.0, 1e-6);  // 8 deg/s
    EXPECT_NEAR(angleAfter2s(1), 8.0, 1e-6);
    EXPECT_EQ(angleAfter2s(2), 0.0);
}

TEST(ScenarioEvents, TargetsAppearStopAndGoByOrder) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    ASSERT_FALSE(state.targets[10].present);  // the fast craft is for level 4
    EXPECT_TRUE(happened(run(*world, state, 0.1, {{0, 0, TargetOrder{10, TargetAction::Appear, 0.0}}}),
                         EventKind::TargetAppeared));
    EXPECT_TRUE(state.targets[10].present);
    (void)run(*world, state, 120.0, {{0, 0, TargetOrder{1, TargetAction::Stop, 0.0}}});
    EXPECT_NEAR(state.targets[1].speed_mps, 0.0, 1e-3);
    EXPECT_TRUE(happened(run(*world, state, 0.1, {{0, 0, TargetOrder{10, TargetAction::Remove, 0.0}}}),
                         EventKind::TargetGone));
}

TEST(ScenarioEvents, AnExerciseEndsAtItsLongestTime) {
    const auto world = test::worldOf(test::lessonWith("/longest_min", "1"));
    State state = startState(*world, 1);
    EXPECT_TRUE(happened(run(*world, state, 61.0), EventKind::Finished));
    EXPECT_TRUE(state.finished);
}

TEST(ScenarioEvents, ANumberThatIsNotFiniteStopsTheExerciseAndNamesTheShip) {
    const auto world = test::worldOf(test::openWaterScenario(2, 0));
    State state = startState(*world, 1);
    state.ships[1].motion.sway_mps = std::numeric_limits<double>::quiet_NaN();
    const auto events = advance(*world, state);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, EventKind::Stopped);
    EXPECT_EQ(events[0].ship, 1);
    EXPECT_STREQ(componentName(events[0].index), "position");
    const auto hash = stateHash(state);
    EXPECT_TRUE(advance(*world, state).empty());
    EXPECT_EQ(stateHash(state), hash);
}

}  // namespace
}  // namespace sagara::core
