#include <gtest/gtest.h>

#include <algorithm>

#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

/// What the bow of a patrol vessel meets in ten minutes half ahead against such a swell.
std::vector<Event> bowEventsIn(const std::string& swells) {
    const auto world = test::worldOf(test::with(test::openWaterScenario(1, 0), "/weather/swells", swells));
    State state = startState(*world, 3);
    std::vector<Command> commands{{0, 0, TelegraphOrder{kAllShafts, TelegraphStep::HalfAhead}}};
    std::vector<Event> found;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) {
        for (const Event& e : advance(*world, state, commands))
            if (e.kind == EventKind::GreenWater || e.kind == EventKind::Slam) found.push_back(e);
        commands.clear();
    }
    return found;
}

TEST(BowWatch, AShortSteepHeadSeaComesOverTheBowAndSlams) {
    const std::vector<Event> events = bowEventsIn(R"([{"height_m": 5.5, "period_s": 8.5, "from_deg": 225}])");
    for (const EventKind kind : {EventKind::GreenWater, EventKind::Slam}) {
        EXPECT_TRUE(
            std::any_of(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; }));
        std::int64_t last = -1'000'000;
        for (const Event& e : events) {
            if (e.kind != kind) continue;
            EXPECT_GT(e.value, 0.0);
            EXPECT_GT(e.tick - last, 15 * kTicksPerSecond) << "told again while it lasts";
            last = e.tick;
        }
    }
}

TEST(BowWatch, InALowSwellNothingIsTold) {
    EXPECT_TRUE(bowEventsIn(R"([{"height_m": 0.5, "period_s": 12, "from_deg": 225}])").empty());
}

}  // namespace
}  // namespace sagara::core
