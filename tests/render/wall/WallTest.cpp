// Real processes over loopback: killed, frozen, slow, cut off and late.
#include <csignal>

#include "RealWall.h"
#include "render/wall/ChannelClient.h"
#include "tests/render/support/Aside.h"
#include "tests/render/support/FakeRenderer.h"

namespace sagara::wall {
namespace {

constexpr std::int64_t kBack_us = 5'000'000;

class Wall : public RealWall {
protected:
    void threeChannels() {
        startServer({"port", "ahead", "starboard"});
        startChannels();
    }
    /// After trouble with a channel: it is noticed, the others go on, and it is back with everything.
    void expectBack(const std::string& channel) {
        const auto before = m_diary.m_backAt_us[channel];
        runUntil([&] { return m_diary.m_lostAt_us.count(channel) > 0; }, 10.0, "the loss is noticed");
        runUntil([&] { return m_diary.m_backAt_us[channel] > before; }, 15.0, "it is back");
        EXPECT_LE(m_diary.m_backAt_us[channel] - m_diary.m_lostAt_us[channel], kBack_us);
        runFor(0.2);
        for (const ChannelStatus& status : m_server->status()) {
            if (status.name != channel) expectUnbroken(status.name);
        }
        expectEqualPictures();
    }
};

TEST_F(Wall, EveryFrameIsShownByAllChannels) {
    threeChannels();
    runFor(1.0);
    for (const ChannelStatus& status : m_server->status()) {
        expectUnbroken(status.name);
        EXPECT_EQ(status.framesMissed, 0u);
        EXPECT_EQ(status.timesLost, 0);
    }
    EXPECT_GT(m_diary.m_shown["ahead"].size(), 20u);
    EXPECT_GT(m_diary.m_spreads_us.size(), 20u);
    expectEqualPictures();
}

TEST_F(Wall, AKilledChannelIsBackWithFullState) {
    threeChannels();
    const auto process = m_channels->find("ahead")->processId();
    signal("ahead", SIGKILL);
    expectBack("ahead");
    EXPECT_NE(m_channels->find("ahead")->processId(), process);
    EXPECT_EQ(m_channels->find("ahead")->starts(), 2);
}

TEST_F(Wall, AFrozenChannelIsKilledAndBackWithFullState) {
    threeChannels();
    signal("port", SIGSTOP);
    expectBack("port");
    EXPECT_EQ(m_diary.m_lostWhy["port"], "drew no picture within 800 ms");
    EXPECT_EQ(m_channels->find("port")->starts(), 2);
}

TEST_F(Wall, AChannelFrozenForAMomentIsBackWithoutARestart) {
    threeChannels();
    signal("port", SIGSTOP);
    runUntil([&] { return m_diary.m_lostAt_us.count("port") > 0; }, 10.0, "the loss is noticed");
    signal("port", SIGCONT);
    expectBack("port");
    EXPECT_EQ(m_channels->find("port")->starts(), 1);
}

TEST_F(Wall, ASlowChannelStaysInStep) {
    threeChannels();
    signal("starboard", SIGUSR1);
    runUntil([&] { return statusOf("starboard").took_us > 50'000; }, 10.0, "it is slow");
    runFor(0.6);
    signal("starboard", SIGUSR2);
    runFor(0.2);
    for (const ChannelStatus& status : m_server->status()) {
        expectUnbroken(status.name);
        EXPECT_EQ(status.timesLost, 0) << status.reason;
    }
}

TEST_F(Wall, AChannelThatWasCutOffReconnects) {
    threeChannels();
    m_server->cut("starboard");
    expectBack("starboard");
    EXPECT_EQ(m_channels->find("starboard")->starts(), 1);
}

TEST_F(Wall, ALateChannelJoinsTheOthers) {
    startServer({"ahead", "late"});
    m_channels->find("ahead")->start();
    runUntil([&] { return statusOf("ahead").framesShown > 10; }, 20.0, "one runs alone");
    m_diary.m_shown.clear();
    m_channels->find("late")->start();
    runUntil([&] { return allInStep(); }, 10.0, "both in step");
    runFor(0.2);
    expectUnbroken("ahead");
    expectEqualPictures();
}

TEST_F(Wall, AllTroublesAtOnce) {
    threeChannels();
    signal("port", SIGSTOP);
    signal("ahead", SIGKILL);
    m_server->cut("starboard");
    runUntil([&] { return m_diary.m_lostAt_us.size() == 3; }, 10.0, "three losses");
    runUntil([&] { return allInStep(); }, 15.0, "all back");
    for (const ChannelStatus& status : m_server->status())
        EXPECT_LE(m_diary.m_backAt_us[status.name] - m_diary.m_lostAt_us[status.name], kBack_us)
            << status.name;
    expectEqualPictures();
}

TEST_F(Wall, AnObserverSeesTheWallAndHoldsUpNobody) {
    startServer({"ahead"});
    startChannels();
    test::FakeRenderer slow(100);
    ChannelOptions options;
    options.port = m_port;
    options.who.role = link::Role::Observer;
    test::Aside observer([&] { (void)runChannel(options, slow, [](const std::string&) {}); });
    runUntil([&] { return statusOf("observer-1").framesShown >= 5; }, 20.0, "it has seen some frames");
    slow.m_closed = true;
    runUntil([&] { return observer.finished(); }, 10.0, "it is closed");
    EXPECT_GE(slow.m_shown.size(), 4u);
    EXPECT_LT(statusOf("ahead").took_us, 90'000);
    expectUnbroken("ahead");
}

TEST_F(Wall, ATokenReachesLocalChannels) {
    WallOptions options;
    options.token = "open sesame";
    startServer({"ahead"}, options);
    startChannels();
}

TEST_F(Wall, OtherPCsNeedAToken) {
    WallOptions options;
    options.everywhere = true;
    options.token = "short";
    WallServer server(
        {}, options, m_world, [] { return Moment{}; }, m_diary);
    const auto port = server.listen();
    ASSERT_FALSE(port);
    EXPECT_EQ(port.error(), "to listen to other PCs a token of 8 characters or more is needed");
}

TEST_F(Wall, AProgramThatDoesNotStartIsReportedAndTriedAgainEverMoreSlowly) {
    std::vector<std::string> told;
    ChannelProcess missing("ahead", {"/nowhere/sagara-view", {}, {}},
                           [&](const auto& m) { told.push_back(m); });
    missing.start();
    runFor(1.2);
    EXPECT_GE(told.size(), 2u);
    EXPECT_LE(told.size(), 4u);
    EXPECT_NE(told.at(0).find("ahead: cannot start /nowhere/sagara-view"), std::string::npos);
}

TEST_F(Wall, TheLastWordsOfAChannelAreReported) {
    std::vector<std::string> told;
    ChannelProcess failing("ahead", {"/bin/sh", {"-c", "echo there is no GL >&2; exit 3"}, {}},
                           [&](const auto& m) { told.push_back(m); });
    failing.start();
    runUntil([&] { return !told.empty(); }, 10.0, "it ends");
    EXPECT_EQ(told[0], "ahead ended with code 3: there is no GL");
}

}  // namespace
}  // namespace sagara::wall
