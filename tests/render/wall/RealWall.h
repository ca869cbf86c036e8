#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <map>
#include <set>

#include "core/exercise/State.h"
#include "render/wall/LocalChannels.h"
#include "render/wall/WallServer.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::wall {

/// Writes down what a wall tells.
class Diary final : public WallObserver {
public:
    struct Shown {
        std::uint64_t frame;
        std::int64_t at_us;
    };
    void inStep(const std::string& channel) override;
    void lost(const std::string& channel, const std::string& reason) override;
    void hangs(const std::string& channel, const std::string& reason) override;
    void shown(const std::string& channel, std::uint64_t frame, std::int64_t at_us) override;
    void frameOver(std::uint64_t, std::int64_t spread_us) override { m_spreads_us.push_back(spread_us); }
    void picture(const std::string& channel, const link::Picture& picture) override;
    void note(const std::string& message) override { m_notes.push_back(message); }

    std::map<std::string, std::vector<Shown>> m_shown;
    std::map<std::string, std::int64_t> m_lostAt_us, m_backAt_us;
    std::map<std::string, std::string> m_lostWhy;
    std::map<std::string, link::Picture> m_pictures;
    std::vector<std::int64_t> m_spreads_us;
    std::vector<std::string> m_notes;
    LocalChannels* m_restarts = nullptr;
};

/// A wall of processes over loopback TCP that draw nothing. Deadlines are long, so that a busy machine does
/// not look like a broken channel.
class RealWall : public ::testing::Test {
protected:
    static constexpr std::int64_t kDeadline_us = 800'000, kSlack_us = 700'000;
    static constexpr int kDraw_ms = 4;

    void SetUp() override;
    void TearDown() override;
    void startServer(std::vector<std::string> channels, WallOptions options = {});
    void startChannels();
    /// Runs the event loop until it is true; fails the test when it is not within `patience_s`.
    template <typename Condition>
    void runUntil(Condition&& condition, double patience_s, const char* what) {
        if (!runWhile([&] { return !condition(); }, patience_s)) FAIL() << "not within time: " << what;
    }
    void runFor(double time_s);
    bool allInStep() const;
    ChannelStatus statusOf(const std::string& channel) const;
    void signal(const std::string& channel, int number);
    /// No frame left out between the first and the last that was shown, and no gap beyond the deadline. Waits
    /// for more where too few were shown to tell.
    void expectUnbroken(const std::string& channel);
    /// Pictures of all channels in step of the same frame: equal only when their worlds and frames are.
    void expectEqualPictures();

    std::shared_ptr<const core::World> m_world;
    Layout m_layout;
    Diary m_diary;
    std::unique_ptr<WallServer> m_server;
    std::unique_ptr<LocalChannels> m_channels;
    std::uint16_t m_port = 0;
    std::int64_t m_tick = 0;

private:
    bool runWhile(const std::function<bool()>& condition, double patience_s);
};

}  // namespace sagara::wall
