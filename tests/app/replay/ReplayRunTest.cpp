#include "app/replay/ReplayRun.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include "app/files/Files.h"
#include "core/exercise/RecordingBranch.h"
#include "tests/support/replay/SampleRecording.h"

namespace sagara::replay {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr double kSailed_s = 100.0;

fs::path scratch(const std::string& name) {
    return fs::temp_directory_path() / ("sagara-replay-" + std::to_string(::getpid()) + "-" + name);
}

core::SimTime seconds(double s) { return {std::llround(1e6 * s)}; }

/// One recording for all tests here, and what the run was like at every second.
class ReplayedRun : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_file = scratch("lively.sgr");
        test::recordLesson(s_file, test::livelyCommands(), kSailed_s, [](const core::State& state) {
            if (state.tick % core::kTicksPerSecond != 0) return;
            s_hashes[state.tick] = core::stateHash(state);
            s_places[state.tick] = state.ships[0].motion.position();
        });
        auto film = openFilm(s_file, [](double) { return true; });
        ASSERT_TRUE(film) << film.error();
        s_film = std::move(film).value();
    }
    static void TearDownTestSuite() {
        s_film.reset();
        fs::remove(s_file);
    }

    static std::unique_ptr<ReplayRun> open(std::shared_ptr<const Film> film = s_film) {
        ui::ReplayResult result = resultOf(*film);
        return std::make_unique<ReplayRun>(std::move(film), std::move(result));
    }
    template <typename Is>
    static bool waitFor(Is&& is) {
        for (int i = 0; i < 1000; ++i) {
            if (is()) return true;
            std::this_thread::sleep_for(10ms);
        }
        return false;
    }
    static std::shared_ptr<const Film> openBytes(const core::Bytes& bytes, const std::string& name) {
        const fs::path file = scratch(name);
        EXPECT_FALSE(files::writeTextFile(
            file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())));
        auto film = openFilm(file, [](double) { return true; });
        fs::remove(file);
        EXPECT_TRUE(film) << film.error();
        return film ? std::move(film).value() : nullptr;
    }

    static inline fs::path s_file;
    static inline std::shared_ptr<const Film> s_film;
    static inline std::map<std::int64_t, std::uint64_t> s_hashes;
    static inline std::map<std::int64_t, core::NorthEast> s_places;
};

TEST_F(ReplayedRun, TheStateOfASoughtSecondIsThatOfTheRunToTheBit) {
    const auto run = open();
    ASSERT_TRUE(run->exact());
    for (const int second : {7, 63, 100, 99, 12, 0, 10, 72, 71}) {
        run->seek(seconds(second));
        ASSERT_TRUE(waitFor([&] { return run->state().has_value(); })) << second;
        const auto state = run->state();
        EXPECT_EQ(core::stateHash(*state), s_hashes[second * core::kTicksPerSecond]) << second;
        const auto picture = run->toDraw();
        EXPECT_TRUE(picture.exact);
        EXPECT_EQ(picture.snapshot.tick, second * core::kTicksPerSecond);
    }
}

TEST_F(ReplayedRun, TheTrackIsShownAtOnceAfterAJump) {
    const auto run = open();
    for (const int second : {90, 3, 55}) {
        run->seek(seconds(second));
        const auto picture = run->toDraw();  // whether or not the run is there already
        EXPECT_EQ(picture.time, seconds(second));
        const auto at = picture.snapshot.ships[0].motion.position();
        EXPECT_LT(core::distance(at, s_places[second * core::kTicksPerSecond]), 0.02)
            << "the track is rounded to the centimetre";
    }
}

TEST_F(ReplayedRun, PlaysEvenlyToTheEndAndStandsThere) {
    const auto run = open();
    run->setRate(20.0);
    run->seek(seconds(20.0));
    run->play();
    core::SimTime last = run->now();
    int exact = 0;
    ASSERT_TRUE(waitFor([&] {
        const auto picture = run->toDraw();
        EXPECT_GE(picture.time, last);
        last = picture.time;
        exact += picture.exact ? 1 : 0;
        return !run->playing();
    }));
    EXPECT_EQ(run->now(), run->end());
    EXPECT_GT(exact, 10);
    run->seek(seconds(5.0));
    EXPECT_FALSE(run->playing()) << "a replay that has come to its end does not go on by itself";
    run->setRate(0.01);
    EXPECT_EQ(run->rate(), ui::kSlowestReplay);
}

TEST_F(ReplayedRun, AnyJumpIsThereWithinASecond) {
    const auto run = open();
    std::chrono::steady_clock::duration longest{};
    for (const double second : {99.0, 1.0, 69.98, 39.98, 9.98}) {
        const auto begin = std::chrono::steady_clock::now();
        run->seek(seconds(second));
        ASSERT_TRUE(waitFor([&] { return run->state().has_value(); }));
        longest = std::max(longest, std::chrono::steady_clock::now() - begin);
    }
    EXPECT_LT(longest, 1s);
}

TEST_F(ReplayedRun, TheWholeIsRunAgainForItsOrdersAndComesOutTheSame) {
    const auto run = open();
    ASSERT_TRUE(waitFor([&] { return run->orders() != nullptr; }));
    const auto orders = run->orders();
    EXPECT_TRUE(orders->verified);
    ASSERT_EQ(orders->samples.size(), run->track().size());
    const auto helm = static_cast<std::size_t>(75 * 5);  // five samples a second; the helm went over at 70 s
    EXPECT_NEAR(orders->samples[helm].rudder_rad, 10.0 * M_PI / 180.0, 1e-9);
}

TEST_F(ReplayedRun, ACutOffRecordingIsShownAsFarAsItIsWhole) {
    auto bytes = files::readBinaryFile(s_file);
    ASSERT_TRUE(bytes);
    const core::Bytes cut(bytes->begin(), bytes->end() - 60'000);  // the header alone is a megabyte
    const auto film = openBytes(cut, "cut.sgr");
    ASSERT_NE(film, nullptr);
    const auto run = open(film);
    EXPECT_NE(run->remark().find("not whole"), std::string::npos) << run->remark();
    EXPECT_GT(run->end(), seconds(5.0));
    EXPECT_LT(run->end(), seconds(kSailed_s));
    run->seek(run->end());
    ASSERT_TRUE(waitFor([&] { return run->state().has_value(); }));
    EXPECT_EQ(core::stateHash(*run->state()), s_hashes[film->endTick()]);
}

TEST_F(ReplayedRun, ARecordingOfAnotherBuildIsShownFromItsTrack) {
    const auto bytes = files::readBinaryFile(s_file);
    ASSERT_TRUE(bytes);
    core::RecordingHeader header = s_film->recording.header;
    header.buildId = "another";
    const auto other = core::recordingUpTo(*bytes, header, 90 * core::kTicksPerSecond);
    ASSERT_TRUE(other) << other.error();
    const auto run = open(openBytes(*other, "other.sgr"));
    EXPECT_FALSE(run->exact());
    EXPECT_NE(run->remark().find("another build"), std::string::npos) << run->remark();
    run->seek(seconds(61.0));
    const auto picture = run->toDraw();
    EXPECT_FALSE(picture.exact);
    EXPECT_LT(
        core::distance(picture.snapshot.ships[0].motion.position(), s_places[61 * core::kTicksPerSecond]),
        0.02);
    EXPECT_GT(picture.snapshot.weather.rain, 0.5) << "of the last state stored before";
    EXPECT_FALSE(run->state().has_value());
}

TEST_F(ReplayedRun, OpeningCanBeCalledOff) {
    const auto film = openFilm(s_file, [](double) { return false; });
    ASSERT_FALSE(film);
    EXPECT_TRUE(film.error().empty());
}

TEST(PlayClock, StandsMovesAndStopsAtTheEnd) {
    PlayClock clock(seconds(10.0), seconds(20.0));
    EXPECT_EQ(clock.at(99), seconds(10.0));
    clock.setRate(2.0, 0);
    clock.play(1'000'000);
    EXPECT_EQ(clock.at(2'500'000), seconds(13.0));
    clock.setRate(0.5, 2'500'000);
    EXPECT_EQ(clock.at(4'500'000), seconds(14.0));
    clock.pause(4'510'000);
    EXPECT_EQ(clock.at(9'000'000), seconds(14.0)) << "to the tick";
    clock.play(0);
    EXPECT_TRUE(clock.playing(11'000'000));
    EXPECT_FALSE(clock.playing(12'000'000));
    EXPECT_EQ(clock.at(60'000'000), seconds(20.0));
    clock.seek(seconds(99.0), 0);
    EXPECT_EQ(clock.at(0), seconds(20.0));
}

TEST(RecordingBranch, TakesWholeSecondsOnly) {
    const core::Bytes nothing;
    EXPECT_FALSE(core::recordingUpTo(nothing, {}, 0));
    const std::string magic = "SGRREC01";
    const auto bytes = std::as_bytes(std::span(magic));
    EXPECT_FALSE(core::recordingUpTo(bytes, {}, 7));
    EXPECT_FALSE(core::recordingUpTo(bytes, {}, -50));
    EXPECT_TRUE(core::recordingUpTo(bytes, {}, 50));
}

}  // namespace
}  // namespace sagara::replay
