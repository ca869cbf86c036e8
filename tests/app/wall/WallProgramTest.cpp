// `sagara-sim wall` as people start it, with channels that draw nothing.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "app/run/WallStatistics.h"
#include "tests/support/Assets.h"

namespace sagara::run {
namespace {

namespace fs = std::filesystem;

class WallProgram : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder =
            fs::temp_directory_path() / ("sagara-wall-" + std::to_string(::getpid()) + "-" +
                                         ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    /// Exit code; both outputs in m_output.
    int run(const std::string& arguments, const char* view = SAGARA_FAKE_VIEW) {
        const std::string log = (m_folder / "log").string();
        const int status =
            std::system((std::string(SAGARA_SIM) + " wall --data " + (m_folder / "data").string() +
                         " --view " + view + " " + arguments + " >" + log + " 2>&1")
                            .c_str());
        m_output = test::readFile(log);
        return WEXITSTATUS(status);
    }
    fs::path m_folder;
    std::string m_output;
};

TEST_F(WallProgram, RunsTheLessonWithThreeChannelsAndComposesTheirPictures) {
    const fs::path shots = m_folder / "shots";
    ASSERT_EQ(run("--scenario basic-navigation --offscreen --size 128x72 --duration-s 1.5 --shot-every-s 0.5 "
                  "--shots " +
                  shots.string()),
              0)
        << m_output;
    EXPECT_NE(m_output.find("3 of 3 channels in step"), std::string::npos) << m_output;
    for (const char* channel : {"port", "ahead", "starboard"}) {
        const std::regex line(std::string("  ") + channel +
                              ": in step, frame .* frames left out: 0 of .*lost never");
        EXPECT_TRUE(std::regex_search(m_output, line)) << m_output;
    }
    EXPECT_TRUE(fs::exists(shots / "wall-0001.png")) << m_output;
    EXPECT_TRUE(fs::exists(shots / "wall-0002.png")) << m_output;
}

TEST_F(WallProgram, TheRealChannelsDrawTheExerciseWithoutAnXServer) {
    const fs::path shots = m_folder / "shots";
    ::unsetenv("DISPLAY");
    ASSERT_EQ(
        run("--scenario basic-navigation --offscreen --size 160x90 --fast --rate-hz 10 --duration-s 1.5 "
            "--shot-every-s 0.5 --shots " +
                shots.string(),
            SAGARA_VIEW),
        0)
        << m_output;
    EXPECT_NE(m_output.find("3 of 3 channels in step"), std::string::npos) << m_output;
    ASSERT_TRUE(fs::exists(shots / "wall-0001.png")) << m_output;
    EXPECT_GT(fs::file_size(shots / "wall-0001.png"), 10'000u);  // one colour would need far less
}

TEST_F(WallProgram, SteppedFramesAreAsManyAsTheTimeHas) {
    ASSERT_EQ(run("--scenario basic-navigation --layout single --offscreen --size 128x72 --fast --rate-hz 25 "
                  "--duration-s 2"),
              0)
        << m_output;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(m_output, found, std::regex("\\(([0-9]+) frames in"))) << m_output;
    EXPECT_NEAR(std::stoi(found[1]), 50, 3) << m_output;
}

TEST_F(WallProgram, OrdersAreTimedUntilTheyShow) {
    ASSERT_EQ(run("--scenario basic-navigation --offscreen --size 128x72 --duration-s 2 --order-every-s 0.3"),
              0)
        << m_output;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(m_output, found, std::regex("([0-9]+) orders, seen on all channels")))
        << m_output;
    EXPECT_GE(std::stoi(found[1]), 4) << m_output;
}

TEST_F(WallProgram, OpensUnderWayAtAnotherHour) {
    const fs::path shots = m_folder / "shots";
    ASSERT_EQ(run("--scenario basic-navigation --helm pilot --layout single --offscreen --size 128x72 --fast "
                  "--rate-hz 10 --at-s 60 --duration-s 0.3 --start-utc 2027-01-15T15:00:00Z --wind-kn 5 "
                  "--visibility-m 500 --rain 0.5 --shots " +
                  shots.string()),
              0)
        << m_output;
    EXPECT_TRUE(fs::exists(shots / "wall-0001.png"));
    EXPECT_EQ(run("--scenario basic-navigation --start-utc yesterday"), 2);
    EXPECT_NE(m_output.find("startUtc"), std::string::npos) << m_output;
}

TEST_F(WallProgram, WrongRequestsAreAnswered) {
    EXPECT_EQ(run("--scenario basic-navigation --layout nowhere"), 2);
    EXPECT_NE(m_output.find("nowhere.json"), std::string::npos) << m_output;
    EXPECT_EQ(run("--scenario nothing"), 2);
    EXPECT_EQ(run("--scenario basic-navigation --listen"), 2);
    EXPECT_NE(m_output.find("a token of 8 characters or more is needed"), std::string::npos) << m_output;
}

TEST(WallStatistics, CountsWhatWasShown) {
    WallStatistics s;
    for (std::uint64_t n = 1; n <= 5; ++n) {
        s.shown("a", n, static_cast<std::int64_t>(40'000 * n));
        s.shown("b", n, static_cast<std::int64_t>(40'000 * n + 500));
        s.frameOver(500);
    }
    EXPECT_EQ(s.text(),
              "25.0 frames/s (5 frames in 0.2 s), every 40.0 ms, p95 40.0, p99 40.0, longest 40.0; channels "
              "apart by "
              "0.5 ms, p95 0.5, most 0.5");
    wall::ChannelStatus status;
    status.name = "a";
    status.state = wall::ChannelState::InStep;
    status.frame = 5;
    status.framesShown = 5;
    status.took_us = 31'000;
    status.timesLost = 1;
    status.reason = "was killed";
    EXPECT_EQ(s.textOf(status),
              "a: in step, frame 5, drawn in 31.0 ms, 0.0 ms after the first; frames left out: 0 of 5, "
              "told to show but not heard of: 0, longest wait 40 ms; lost once (was killed)");
}

}  // namespace
}  // namespace sagara::run
