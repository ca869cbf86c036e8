#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Archive.h"
#include "core/base/Random.h"
#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

constexpr std::int64_t kTicks =
    150 * kTicksPerSecond;  // lines let go, spring, backing, turning: contact and all

/// Everything a trainee and a trainer might do in the first minutes.
std::vector<Command> busyCommands() {
    WeatherOrder squall;
    squall.windSpeed_mps = 12.0;
    squall.ramp_s = 40.0;
    return {{0, 0, PilotOrder{true}},
            {20 * kTicksPerSecond, 0, squall},
            {60 * kTicksPerSecond, 0, DifficultyOrder{5}},
            {100 * kTicksPerSecond, 0, FaultOrder{Fault::SteeringPump, 1, false}},
            {120 * kTicksPerSecond, 0, PilotOrder{false}},
            {121 * kTicksPerSecond, 0, HelmOrder{0.2}},
            {125 * kTicksPerSecond, 0, TelegraphOrder{kAllShafts, TelegraphStep::SlowAhead}}};
}

std::span<const Command> due(const std::vector<Command>& commands, std::int64_t tick) {
    const auto first =
        std::find_if(commands.begin(), commands.end(), [&](const Command& c) { return c.tick >= tick; });
    auto last = first;
    while (last != commands.end() && last->tick == tick) ++last;
    return {first, last};
}

void step(const World& world, State& state) {
    static const std::vector<Command> commands = busyCommands();
    (void)advance(world, state, due(commands, state.tick));
}

std::uint64_t hashAfter(const World& world, std::int64_t ticks) {
    State state = startState(world, 3);
    while (state.tick < ticks) step(world, state);
    return stateHash(state);
}

TEST(Determinism, SameSeedAndCommandsGiveTheSameBytes) {
    const auto a = test::lessonWorld(7), b = test::lessonWorld(7);
    EXPECT_EQ(hashAfter(*a, kTicks), hashAfter(*b, kTicks));
}

TEST(Determinism, AnotherSeedGivesAnotherRun) {
    EXPECT_NE(hashAfter(*test::lessonWorld(7), 1000), hashAfter(*test::lessonWorld(8), 1000));
}

TEST(Determinism, TwoRunsThatInterleaveDoNotTouchEachOther) {
    const auto a = test::lessonWorld(7), b = test::lessonWorld(8);
    State first = startState(*a, 3), second = startState(*b, 3);
    Random random(5);
    while (first.tick < kTicks || second.tick < kTicks) {
        State& state =
            second.tick >= kTicks || (first.tick < kTicks && random.uniform() < 0.5) ? first : second;
        step(&state == &first ? *a : *b, state);
    }
    EXPECT_EQ(stateHash(first), hashAfter(*a, kTicks));
    EXPECT_EQ(stateHash(second), hashAfter(*b, kTicks));
}

TEST(Determinism, SavingAndLoadingAtRandomTicksChangesNothing) {
    const auto world = test::lessonWorld(7);
    State state = startState(*world, 3);
    Random random(6);
    std::int64_t next = 0;
    while (state.tick < kTicks) {
        if (state.tick == next) {
            auto loaded = fromBytes<State>(toBytes(state));
            ASSERT_TRUE(loaded);
            ASSERT_EQ(stateHash(*loaded), stateHash(state));
            state = std::move(*loaded);
            next += 1 + static_cast<std::int64_t>(random.next() % 700);
        }
        step(*world, state);
    }
    EXPECT_EQ(stateHash(state), hashAfter(*world, kTicks));
}

TEST(Determinism, LookingAheadFromACopyLeavesTheRunAlone) {
    const auto world = test::lessonWorld(7);
    State state = startState(*world, 3);
    while (state.tick < kTicks) {
        if (state.tick % 1500 == 0) {
            State ahead = state;
            for (int i = 0; i < 500; ++i) (void)advance(*world, ahead, {});
        }
        step(*world, state);
    }
    EXPECT_EQ(stateHash(state), hashAfter(*world, kTicks));
}

}  // namespace
}  // namespace sagara::core
