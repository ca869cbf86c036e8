#include "app/live/LiveRun.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "core/exercise/Recording.h"
#include "core/exercise/Replay.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::live {
namespace {

using namespace std::chrono_literals;

class Live : public ::testing::Test {
protected:
    std::shared_ptr<const core::World> m_world = test::worldOf(test::openWaterScenario(1, 2));
    core::State m_start = core::startState(*m_world, 3);

    static void waitFor(const std::function<bool()>& done) {
        for (int i = 0; i < 2000 && !done(); ++i) std::this_thread::sleep_for(5ms);
        EXPECT_TRUE(done()) << "not within ten seconds";
    }

    wall::FrameClock clock;
};

TEST_F(Live, StandsStillUntilItIsStarted) {
    LiveRun run(m_world, m_start, {});
    std::this_thread::sleep_for(60ms);
    EXPECT_EQ(run.latest()->tick, 0);
    EXPECT_FALSE(run.running());
    EXPECT_EQ(run.toDraw(clock).snapshot.tick, 0);
    run.start();
    waitFor([&] { return run.latest()->tick >= 5; });
}

TEST_F(Live, FreezesAndGoesOnWithoutAJump) {
    LiveRun run(m_world, m_start, {});
    run.start();
    waitFor([&] { return run.latest()->tick >= 5; });
    run.freeze();
    std::this_thread::sleep_for(60ms);  // a tick under way is finished
    const std::int64_t tick = run.latest()->tick;
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(run.latest()->tick, tick);
    run.start();
    waitFor([&] { return run.latest()->tick > tick; });
    EXPECT_LE(run.latest()->tick, tick + 100) << "the time it was frozen is not made up for";
}

TEST_F(Live, RunsFasterWhenAsked) {
    LiveRun run(m_world, m_start, {});
    run.setRate(1000.0);
    EXPECT_EQ(run.rate(), kFastestRate);
    run.start();
    const auto begin = std::chrono::steady_clock::now();
    waitFor([&] { return run.latest()->tick >= 400; });  // 8 s of the exercise
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 8s);
    EXPECT_LE(run.toDraw(clock).time, run.latest()->time());
}

TEST_F(Live, CarriesOutOrdersAndTellsWhen) {
    LiveRun run(m_world, m_start, {});
    run.give(0, core::HelmOrder{0.1});
    EXPECT_FALSE(run.carriedOut());
    run.start();
    waitFor([&] { return run.carriedOut().has_value(); });
    waitFor([&] { return run.latest()->time() >= *run.carriedOut(); });
    EXPECT_EQ(run.latest()->ships[0].rudderOrder_rad, 0.1);
    EXPECT_EQ(run.state().ships.size(), 1u);
}

TEST_F(Live, EventsAreKeptAndHandedOutFromAnIndexOn) {
    LiveRun run(m_world, m_start, {{5, 0, core::DifficultyOrder{4}}, {8, 0, core::FinishOrder{}}});
    run.setRate(20.0);
    run.start();
    waitFor([&] { return run.over(); });
    const auto events = run.eventsFrom(0);
    ASSERT_GE(events.size(), 2u);
    EXPECT_EQ(events.front().kind, core::EventKind::LevelChanged);
    EXPECT_EQ(events.back().kind, core::EventKind::Finished);
    EXPECT_EQ(run.eventsFrom(1).size(), events.size() - 1);
    EXPECT_TRUE(run.eventsFrom(1000).empty());
    EXPECT_FALSE(run.running());
    run.start();
    EXPECT_FALSE(run.running()) << "what is over stays over";
}

TEST_F(Live, IsRecordedToTheBit) {
    core::Bytes bytes;
    core::RecordingWriter writer(
        [&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
    core::RecordingHeader header;
    header.buildId = "live";
    header.level = 3;
    header.documents = m_world->documents;
    writer.begin(header, *m_world, m_start);
    core::State end;
    {
        LiveRun run(m_world, m_start, {}, &writer);
        run.setRate(20.0);
        run.start();
        waitFor([&] { return run.latest()->tick >= 30; });
        run.give(0, core::HelmOrder{0.2});
        waitFor([&] { return run.latest()->tick >= 120; });
        run.stop();
        end = run.state();
        writer.end(end);
    }
    const auto recording = core::readRecording(bytes);
    ASSERT_TRUE(recording) << recording.error();
    ASSERT_EQ(recording->commands.size(), 1u);
    EXPECT_EQ(recording->end->stateHash, core::stateHash(end));
}

}  // namespace
}  // namespace sagara::live
