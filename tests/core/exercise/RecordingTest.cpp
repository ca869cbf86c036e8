#include "core/exercise/Recording.h"

#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "core/exercise/Advance.h"
#include "core/exercise/BuildId.h"
#include "core/exercise/Replay.h"
#include "core/exercise/Session.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

/// A minute of the lesson, with pilot and a trainer's order, recorded.
class Recorded : public ::testing::Test {
protected:
    static constexpr std::int64_t kTicks = 60 * kTicksPerSecond + 17;  // broken off within a second
    std::shared_ptr<const World> world;
    Bytes bytes;
    std::uint64_t endHash = 0;

    void SetUp() override {
        world = test::lessonWorld();
        RecordingWriter writer([this](std::span<const std::byte> piece) { append(bytes, piece); });
        RecordingHeader header;
        header.buildId = coreBuildId();
        header.seed = 1;
        header.level = 3;
        header.runType = "train";
        header.trainee = "A. Perera";
        header.documents = world->documents;
        header.planned = {{0, 0, PilotOrder{true}}};
        Session session(world, startState(*world, 3), header.planned, &writer);
        writer.begin(header, *world, session.state());
        while (session.state().tick < kTicks) {
            if (session.state().tick == 1234) session.give(0, DifficultyOrder{5});
            (void)session.step();
        }
        writer.end(session.state());
        endHash = stateHash(session.state());
    }
};

TEST_F(Recorded, IsReadBackWhole) {
    const auto recording = readRecording(bytes);
    ASSERT_TRUE(recording) << recording.error();
    EXPECT_EQ(recording->damage, "");
    EXPECT_EQ(recording->header.trainee, "A. Perera");
    EXPECT_EQ(recording->endTick, kTicks);
    EXPECT_EQ(recording->end->stateHash, endHash);
    EXPECT_EQ(recording->states.size(), 7u);  // at 0, 10, ... 60 s
    EXPECT_EQ(recording->commands.size(), 2u);
    EXPECT_EQ(recording->track(1, world->targets.size()).size(), 302u);
    EXPECT_EQ(recording->whole_bytes, bytes.size());
}

TEST_F(Recorded, ReplaysToTheBit) {
    const auto recording = readRecording(bytes);
    const auto again = worldOf(*recording);
    ASSERT_TRUE(again);
    const auto last = replay(**again, *recording, kTicks, [](const auto&, auto, auto) {});
    ASSERT_TRUE(last) << last.error();
    EXPECT_EQ(stateHash(*last), endHash);
}

TEST_F(Recorded, AnySecondIsReachedAndIsTheSameAsOnTheWay) {
    const auto recording = readRecording(bytes);
    std::vector<std::uint64_t> hashes;
    (void)replay(*world, *recording, kTicks,
                 [&](const State& s, auto, auto) { hashes.push_back(stateHash(s)); });
    Random random(2);
    for (int i = 0; i < 20; ++i) {
        const auto tick = static_cast<std::int64_t>(1 + random.next() % kTicks);
        const auto state = stateAt(*world, *recording, tick);
        ASSERT_TRUE(state) << state.error();
        EXPECT_EQ(stateHash(*state), hashes[static_cast<std::size_t>(tick - 1)]) << tick;
    }
    EXPECT_FALSE(stateAt(*world, *recording, kTicks + 1));
}

TEST_F(Recorded, CutOffAnywhereItIsReadAsFarAsItIsWhole) {
    Random random(3);
    std::int64_t before = -1;
    for (std::size_t size = bytes.size() - 40'000; size < bytes.size(); size += 1 + random.next() % 997) {
        const auto recording = readRecording(std::span(bytes).first(size));
        ASSERT_TRUE(recording);
        EXPECT_NE(recording->damage, "");
        EXPECT_LE(recording->whole_bytes, size);
        EXPECT_GE(recording->endTick, before);
        before = recording->endTick;
        EXPECT_TRUE(stateAt(*world, *recording, recording->endTick));
    }
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, std::size_t{8}, std::size_t{20}, std::size_t{5000}}) {
        EXPECT_FALSE(readRecording(std::span(bytes).first(size)));
    }
}

TEST_F(Recorded, CutOffBeforeItsFirstStateItIsNone) {
    const std::size_t header_bytes = 13 + toBytes(readRecording(bytes)->header).size();
    const auto recording = readRecording(std::span(bytes).first(8 + header_bytes));
    ASSERT_FALSE(recording);
    EXPECT_EQ(
        recording.error(),
        "has no whole state to begin from, so nothing of the run can be read (the end is missing: the run "
        "was broken off)");
    EXPECT_EQ(
        readRecording(std::span(bytes).first(8)).error(),
        "has no whole header, so nothing of the run can be read (the end is missing: the run was broken "
        "off)");
}

TEST_F(Recorded, AFlippedBitIsFoundAndWhatIsBeforeItIsKept) {
    const std::size_t first = bytes.size() - 60'000;
    Random random(4);
    for (int i = 0; i < 60; ++i) {
        const std::size_t at = first + random.next() % (bytes.size() - first);
        const auto bit = static_cast<std::byte>(1U << (random.next() % 8));
        bytes[at] ^= bit;
        const auto recording = readRecording(bytes);
        ASSERT_TRUE(recording);
        EXPECT_NE(recording->damage, "") << at;
        EXPECT_LE(recording->whole_bytes, at);
        bytes[at] ^= bit;
    }
    bytes[1000] ^= std::byte{1};  // in the header: nothing can be read
    EXPECT_FALSE(readRecording(bytes));
}

TEST_F(Recorded, GradedFromTheTrackItComesOutAsGradedInTheRun) {
    const auto recording = readRecording(bytes);
    const auto last = stateAt(*world, *recording, kTicks);
    const Grading grading = gradeTrack(world->mission, world->path,
                                       recording->track(1, world->targets.size()), recording->events, kTicks);
    ASSERT_TRUE(last->assessment.tasks[0].done);
    EXPECT_EQ(grading.assessment.tasks[0].done, last->assessment.tasks[0].done);
    EXPECT_EQ(grading.assessment.tasks[0].doneAt, last->assessment.tasks[0].doneAt);
    EXPECT_EQ(grading.assessment.currentTask, last->assessment.currentTask);
    EXPECT_NEAR(scoreOf(grading.assessment), scoreOf(last->assessment), 1e-9);
}

TEST_F(Recorded, ARunOfAnotherBuildSaysSoAndStillHasItsTrack) {
    auto recording = std::move(readRecording(bytes)).value();
    recording.header.buildId = "0123456789abcdef";
    const auto state = stateAt(*world, recording, 100);
    ASSERT_FALSE(state);
    EXPECT_EQ(
        state.error(),
        "the run was made by another build of Sagara (0123456789abcdef) and cannot be run again to the bit");
    EXPECT_GT(recording.track(1, world->targets.size()).size(), 100u);
}

TEST_F(Recorded, AStateThatComesOutOtherwiseIsNamed) {
    auto recording = std::move(readRecording(bytes)).value();
    recording.commands.back().order = DifficultyOrder{4};  // not what was sailed
    const auto last = replay(*world, recording, kTicks, [](const auto&, auto, auto) {});
    ASSERT_FALSE(last);
    EXPECT_EQ(last.error(), "the run comes out otherwise from 30 s on");
}

TEST_F(Recorded, TrackKeepsTheValuesToItsRounding) {
    const auto recording = readRecording(bytes);
    const auto track = recording->track(1, world->targets.size());
    for (const std::size_t i : {std::size_t{0}, std::size_t{50}, std::size_t{299}}) {
        const auto state = stateAt(*world, *recording, track[i].tick);
        const TrackSample exact = sampleOf(*world, *state);
        const ShipSample &kept = track[i].ships[0], &was = exact.ships[0];
        EXPECT_NEAR(kept.motion.north_m, was.motion.north_m, 0.0051);
        EXPECT_NEAR(kept.motion.heading_rad, was.motion.heading_rad, 0.51e-4);
        EXPECT_NEAR(kept.observation.underKeel_m, was.observation.underKeel_m, 0.0051);
        EXPECT_EQ(kept.observation.linesFast, was.observation.linesFast);
        EXPECT_EQ(kept.observation.level, was.observation.level);
        EXPECT_NEAR(track[i].targets[0].position.east_m, exact.targets[0].position.east_m, 0.051);
    }
}

TEST_F(Recorded, RandomBytesAreNeverARecordingAndNeverACrash) {
    Random random(9);
    for (int i = 0; i < 10'000; ++i) {
        Bytes buffer(random.next() % 300);
        for (std::byte& b : buffer) b = static_cast<std::byte>(random.next());
        if (i % 2)
            buffer.insert(buffer.begin(), bytes.begin(), bytes.begin() + 8);  // behind the right first bytes
        EXPECT_FALSE(readRecording(buffer));
    }
}

TEST_F(Recorded, CodecSurvivesAnyBytes) {
    Random random(10);
    for (int i = 0; i < 2000; ++i) {
        Bytes buffer(random.next() % 400);
        for (std::byte& b : buffer) b = static_cast<std::byte>(random.next());
        TrackCodec codec;
        TrackSample sample;
        std::span<const std::byte> rest(buffer);
        while (codec.decode(rest, 2, 3, sample)) {
            for (const ShipSample& ship : sample.ships) {  // what comes of it can be graded
                ASSERT_GE(ship.observation.level, 1);
                ASSERT_LE(ship.observation.level, kLevels);
            }
        }
    }
}

TEST_F(Recorded, TakenUpAgainAtItsLastWholeSecondItEndsTheSame) {
    // the file as a kill at 47.3 s would leave it
    const auto full = readRecording(bytes);
    std::size_t cut = bytes.size();
    for (std::size_t size = bytes.size(); size > 0; size -= 500) {
        const auto part = readRecording(std::span(bytes).first(size));
        if (part && part->endTick <= 47 * kTicksPerSecond) {
            cut = size;
            break;
        }
    }
    const auto part = std::move(readRecording(std::span(bytes).first(cut))).value();
    ASSERT_LT(part.endTick, 48 * kTicksPerSecond);
    auto state = stateAt(*world, part, part.endTick);
    ASSERT_TRUE(state);

    Bytes resumed(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(part.whole_bytes));
    RecordingWriter writer([&](std::span<const std::byte> piece) { append(resumed, piece); });
    writer.goOn(*state);
    Session session(world, std::move(state).value(), part.header.planned, &writer);
    while (session.state().tick < kTicks) (void)session.step();
    writer.end(session.state());
    EXPECT_EQ(stateHash(session.state()), endHash);

    const auto whole = readRecording(resumed);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->damage, "");
    EXPECT_EQ(whole->commands.size(), full->commands.size());
    EXPECT_EQ(whole->track(1, world->targets.size()).size(), 302u);
    const auto last = replay(*world, *whole, kTicks, [](const auto&, auto, auto) {});
    ASSERT_TRUE(last) << last.error();
    EXPECT_EQ(stateHash(*last), endHash);
}

TEST(RecordingSize, AnHourOf2OwnShipsAnd20TargetsIsAtMost20MB) {
    const auto world = test::worldOf(test::openWaterScenario(2, 20));
    std::size_t size = 0, afterHeader = 0;
    RecordingWriter writer([&](std::span<const std::byte> piece) { size += piece.size(); });
    RecordingHeader header;
    header.documents = world->documents;
    Session session(world, startState(*world, 3), {}, &writer);
    writer.begin(header, *world, session.state());
    afterHeader = size;
    constexpr int kMinutes = 3;  // every minute is like the other
    while (session.state().tick < kMinutes * 60 * kTicksPerSecond) (void)session.step();
    const double hour =
        static_cast<double>(afterHeader) + static_cast<double>(size - afterHeader) * 60.0 / kMinutes;
    RecordProperty("bytesOfAnHour", std::to_string(hour));
    EXPECT_LE(hour, 20e6);
    std::printf("an hour: %.1f MB, of which documents %.1f MB\n", hour / 1e6,
                static_cast<double>(afterHeader) / 1e6);
}

}  // namespace
}  // namespace sagara::core
