#include <gtest/gtest.h>

#include <algorithm>

#include "core/exercise/Advance.h"
#include "core/exercise/OrderDocument.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

struct Sailed {
    State state;
    std::vector<Event> events;
};

Sailed sail(const World& world, int level, const std::vector<Command>& commands) {
    Sailed s{startState(world, level), {}};
    std::size_t next = 0;
    while (!s.state.finished && !s.state.stopped) {
        const std::size_t first = next;
        while (next < commands.size() && commands[next].tick == s.state.tick) ++next;
        const auto now = advance(world, s.state, std::span(commands).subspan(first, next - first));
        s.events.insert(s.events.end(), now.begin(), now.end());
    }
    return s;
}

class PilotSailsTheLesson : public ::testing::TestWithParam<std::pair<int, std::uint64_t>> {};
TEST_P(PilotSailsTheLesson, AndPasses) {
    const auto [level, seed] = GetParam();
    const auto world = test::lessonWorld(seed);
    const Sailed s = sail(*world, level, {{0, 0, PilotOrder{true}}});
    EXPECT_TRUE(passed(world->mission, s.state.assessment));
    EXPECT_GE(scoreOf(s.state.assessment), 70.0);
    double before_s = 0.0;
    for (const TaskMemory& task : s.state.assessment.tasks) {
        EXPECT_TRUE(task.done);
        EXPECT_GE(task.doneAt.seconds(), before_s);
        before_s = task.doneAt.seconds();
    }
    const double limit_s[] = {45 * 60, 40 * 60, 35 * 60, 31 * 60, 28 * 60};
    EXPECT_LE(before_s, limit_s[level - 1]);
    EXPECT_LT(std::abs(s.state.ships[0].motion.surge_mps), 0.8);  // the swell surges her at her anchor
    EXPECT_FALSE(std::any_of(s.events.begin(), s.events.end(), [](const Event& e) {
        return e.kind == EventKind::Grounding || e.kind == EventKind::LineParted || e.kind == EventKind::CableParted;
    }));
}
INSTANTIATE_TEST_SUITE_P(LevelsAndSeeds, PilotSailsTheLesson,
                         ::testing::Values(std::pair{1, 1}, std::pair{2, 21}, std::pair{3, 1}, std::pair{3, 33}, std::pair{4, 44},
                                           std::pair{5, 1}, std::pair{5, 55}),
                         [](const auto& row) {
                             return "Level" + std::to_string(row.param.first) + "Seed" + std::to_string(row.param.second);
                         });

}  // namespace
}  // namespace sagara::core
