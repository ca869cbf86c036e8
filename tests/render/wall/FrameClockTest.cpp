#include "render/wall/FrameClock.h"

#include <gtest/gtest.h>

namespace sagara::wall {
namespace {

/// The simulation publishes tick n at n x 20 ms of the wall clock, some of them late.
core::SimTime newestAt(std::int64_t wall_us, std::int64_t late_us = 0) {
    return core::timeOfTick((wall_us - late_us) / core::kTick_us);
}

TEST(FrameClock, AdvancesByTheFrameTimeExactlyWhateverTheTicksDo) {
    for (const std::int64_t frame_us : {6'944, 16'667, 33'333, 40'000, 43'478}) {
        FrameClock clock;
        std::int64_t wall_us = 1'000'000;
        core::SimTime before = clock.at(wall_us, newestAt(wall_us));
        int uneven = 0;
        for (int n = 0; n < 1000; ++n) {
            wall_us += frame_us;
            const std::int64_t late_us = n % 7 == 0 ? 12'000 : 0;
            const core::SimTime now = clock.at(wall_us, newestAt(wall_us, late_us));
            if (n >= 200 && now.us - before.us != frame_us) ++uneven;
            before = now;
        }
        EXPECT_EQ(uneven, 0) << frame_us << " us: it has found out by then how late ticks come";
    }
}

TEST(FrameClock, IsOneTickBehindAndNeverAheadOfTheNewest) {
    FrameClock clock;
    EXPECT_EQ(clock.at(500'000, core::timeOfTick(25)), core::timeOfTick(24));
    for (std::int64_t wall_us = 500'000; wall_us < 3'000'000; wall_us += 11'111)
        EXPECT_LE(clock.at(wall_us, newestAt(wall_us)), newestAt(wall_us));
}

TEST(FrameClock, StandsWhileTheSimulationStandsAndGoesOnFromThere) {
    FrameClock clock;
    (void)clock.at(1'000'000, core::timeOfTick(50));
    EXPECT_EQ(clock.at(3'000'000, core::timeOfTick(50)), core::timeOfTick(50));
    EXPECT_EQ(clock.at(3'010'000, core::timeOfTick(51)), core::timeOfTick(50));
    EXPECT_EQ(clock.at(3'015'000, core::timeOfTick(51)).us, core::timeOfTick(50).us + 5'000);
}

TEST(FrameClock, JumpsWhenTheSimulationIsFarAhead) {
    FrameClock clock;
    (void)clock.at(1'000'000, core::timeOfTick(50));
    EXPECT_EQ(clock.at(1'010'000, core::timeOfTick(500)), core::timeOfTick(499));
    EXPECT_EQ(clock.at(1'030'000, core::timeOfTick(10)), core::timeOfTick(9)) << "set back";
}

TEST(FrameClock, RunsFasterWhenTheSimulationDoes) {
    FrameClock clock(4.0);
    const core::SimTime a = clock.at(1'000'000, core::timeOfTick(100));
    EXPECT_EQ(clock.at(1'010'000, core::timeOfTick(102)).us - a.us, 40'000);
}

}  // namespace
}  // namespace sagara::wall
