#include "RealWall.h"

#include <QTimer>
#include <csignal>

#include "render/link/SteadyClock.h"

namespace sagara::wall {

void Diary::inStep(const std::string& channel) { m_backAt_us[channel] = link::steadyClock_us(); }
void Diary::lost(const std::string& channel, const std::string& reason) {
    m_lostAt_us[channel] = link::steadyClock_us();
    m_lostWhy[channel] = reason;
}
void Diary::hangs(const std::string& channel, const std::string&) {
    if (m_restarts) m_restarts->restart(channel);
}
void Diary::shown(const std::string& channel, std::uint64_t frame, std::int64_t at_us) {
    m_shown[channel].push_back({frame, at_us});
}
void Diary::picture(const std::string& channel, const link::Picture& picture) {
    m_pictures[channel] = picture;
}

void RealWall::SetUp() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    static QCoreApplication application(argc, argv);
    m_world = test::worldOf(test::openWaterScenario(1, 3));
}

void RealWall::TearDown() {
    if (m_server) m_server->stop("the test is over");
    if (m_channels) m_channels->stop(1000);
}

void RealWall::startServer(std::vector<std::string> channels, WallOptions options) {
    m_layout.id = "test";
    for (const std::string& name : channels) {
        LayoutChannel channel;
        channel.view.name = name;
        channel.view.width_px = 64;
        channel.view.height_px = 36;
        channel.view.output = link::Output::Offscreen;
        m_layout.channels.push_back(channel);
    }
    options.rules.deadline_us = kDeadline_us;
    const core::Snapshot start = core::view(*m_world, core::startState(*m_world, 3));
    m_server = std::make_unique<WallServer>(
        m_layout, options, m_world,
        [this, start] {
            Moment moment{core::timeOfTick(++m_tick), start};
            moment.snapshot.tick = m_tick;
            moment.snapshot.ships[0].motion.north_m += 0.1 * static_cast<double>(m_tick);
            return moment;
        },
        m_diary);
    const auto port = m_server->listen();
    ASSERT_TRUE(port) << port.error();
    m_port = *port;
    m_channels = std::make_unique<LocalChannels>(
        m_layout, LocalChannels::Program{SAGARA_FAKE_VIEW, {"--draw-ms", std::to_string(kDraw_ms)}}, m_port,
        options.token, [this](const std::string& message) { m_diary.m_notes.push_back(message); });
    m_diary.m_restarts = m_channels.get();
}

void RealWall::startChannels() {
    m_channels->start();
    runUntil([&] { return allInStep(); }, 20.0, "all channels in step");
    m_diary.m_shown.clear();
}

bool RealWall::runWhile(const std::function<bool()>& condition, double patience_s) {
    QTimer beat;
    beat.start(5);
    const std::int64_t until_us = link::steadyClock_us() + static_cast<std::int64_t>(1e6 * patience_s);
    while (condition()) {
        if (link::steadyClock_us() > until_us) return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

void RealWall::runFor(double time_s) {
    (void)runWhile([] { return true; }, time_s);
}

bool RealWall::allInStep() const {
    for (const ChannelStatus& status : m_server->status()) {
        if (status.waitedFor && status.state != ChannelState::InStep) return false;
    }
    return true;
}

ChannelStatus RealWall::statusOf(const std::string& channel) const {
    for (const ChannelStatus& status : m_server->status()) {
        if (status.name == channel) return status;
    }
    return {};
}

void RealWall::signal(const std::string& channel, int number) {
    ::kill(static_cast<pid_t>(m_channels->find(channel)->processId()), number);
}

void RealWall::expectUnbroken(const std::string& channel) {
    const auto& shown = m_diary.m_shown[channel];
    ASSERT_NO_FATAL_FAILURE(runUntil([&] { return shown.size() > 10; }, 10.0, channel.c_str()));
    for (std::size_t i = 1; i < shown.size(); ++i) {
        ASSERT_EQ(shown[i].frame, shown[i - 1].frame + 1) << channel;
        ASSERT_LE(shown[i].at_us - shown[i - 1].at_us, kDeadline_us + kSlack_us) << channel;
    }
}

void RealWall::expectEqualPictures() {
    m_diary.m_pictures.clear();
    m_server->askForPictures();
    runUntil([&] { return m_diary.m_pictures.size() == m_layout.channels.size(); }, 10.0,
             "a picture of each");
    const link::Picture& first = m_diary.m_pictures.begin()->second;
    for (const auto& [channel, picture] : m_diary.m_pictures) {
        EXPECT_EQ(picture.frame, first.frame) << channel;
        EXPECT_EQ(picture.bgra, first.bgra) << channel;
    }
}

}  // namespace sagara::wall
