// Either side of a live link against a peer that sends anything.
#include <QTcpServer>
#include <QTcpSocket>

#include "RealWall.h"
#include "render/link/Codec.h"
#include "render/link/Handshake.h"
#include "render/wall/ChannelClient.h"
#include "tests/render/support/Aside.h"
#include "tests/render/support/FakeRenderer.h"
#include "tests/render/support/Hostile.h"

namespace sagara::wall {
namespace {

constexpr int kPatience_ms = 10'000;

class HostilePeer : public RealWall {
protected:
    void runAside(std::function<void()> work) {
        test::Aside thread(std::move(work));
        runUntil([&] { return thread.finished(); }, 60.0, "the hostile peer is through");
        thread.wait();
    }
};

TEST_F(HostilePeer, StrangersDoNotDisturbTheWall) {
    startServer({"ahead"});
    startChannels();
    runAside([port = m_port] {
        test::HostileBytes hostile(1);
        for (int i = 0; i < 3000; ++i) {
            QTcpSocket socket;
            socket.connectToHost(QStringLiteral("127.0.0.1"), port);
            if (!socket.waitForConnected(kPatience_ms)) return;
            for (int k = 0; k < 4; ++k) {
                const core::Bytes bytes = hostile.next();
                if (socket.state() != QAbstractSocket::ConnectedState) break;
                socket.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
            }
            socket.flush();
        }
    });
    expectUnbroken("ahead");
    EXPECT_EQ(statusOf("ahead").timesLost, 0);
}

TEST_F(HostilePeer, AChannelThatGoesMadDoesNotDisturbTheOthers) {
    startServer({"ahead", "mad"});
    m_channels->find("ahead")->start();
    runUntil([&] { return statusOf("ahead").framesShown > 5; }, 20.0, "one runs");
    m_diary.m_shown.clear();
    int welcomed = 0;
    runAside([&welcomed, port = m_port] {
        test::HostileBytes hostile(2);
        for (int i = 0; i < 400; ++i) {
            auto connection = link::Connection::to("127.0.0.1", port, kPatience_ms, link::kBeforeGreeting);
            if (!connection) return;
            if (!link::introduce(**connection, {link::Role::View, "mad", ""}, kPatience_ms)) continue;
            ++welcomed;
            (*connection)->send(link::Ready{});
            for (std::uint64_t k = 0; k < 5; ++k) {
                (*connection)->send(link::Rendered{k, 0});
                (*connection)->sendPacket(hostile.next());
            }
        }
    });
    EXPECT_GT(welcomed, 100);
    runFor(0.5);
    expectUnbroken("ahead");
    EXPECT_EQ(statusOf("ahead").timesLost, 0);
}

/// Connects channel after channel to a station that behaves for a while.
class HostileStation : public HostilePeer {
protected:
    enum class Until { Greeting, Welcome, Setup, Frame };
    int serve(Until until, int times, std::uint64_t seed) {
        QTcpServer server;
        EXPECT_TRUE(server.listen(QHostAddress::LocalHost));
        int ends = 0;
        test::Aside channel([&ends, times, port = server.serverPort()] {
            for (int i = 0; i < times; ++i) {
                test::FakeRenderer renderer(0);
                ChannelOptions options;
                options.port = port;
                options.patience_s = 0.0;
                const ChannelEnd end = runChannel(options, renderer, [](const std::string&) {});
                EXPECT_FALSE(end.reason.empty());
                ++ends;
            }
        });
        test::HostileBytes hostile(seed);
        for (int i = 0; i < times; ++i) {
            EXPECT_TRUE(server.waitForNewConnection(kPatience_ms));
            link::Connection c(std::unique_ptr<QTcpSocket>(server.nextPendingConnection()),
                               link::kBeforeHello);
            if (until > Until::Greeting) {
                c.send(link::greeting());
                (void)c.wait(kPatience_ms);
                c.expect(link::kFromChannel);
            }
            if (until > Until::Welcome) {
                c.send(link::Welcome{});
                c.send(link::Setup{m_world->documents, m_world->seed});
                (void)c.wait(kPatience_ms);
            }
            if (until > Until::Setup) {
                c.send(link::Frame{1, {}, core::view(*m_world, core::startState(*m_world, 3))});
                (void)c.wait(kPatience_ms);
            }
            for (int k = 0; k < 8; ++k) c.sendPacket(hostile.next());
            c.close("done");
        }
        channel.wait();
        return ends;
    }
};

TEST_F(HostileStation, BeforeItGreets) { EXPECT_EQ(serve(Until::Greeting, 1000, 3), 1000); }
TEST_F(HostileStation, BeforeItWelcomes) { EXPECT_EQ(serve(Until::Welcome, 1000, 4), 1000); }
TEST_F(HostileStation, InPlaceOfFrames) { EXPECT_EQ(serve(Until::Setup, 15, 5), 15); }
TEST_F(HostileStation, InTheMiddleOfARun) { EXPECT_EQ(serve(Until::Frame, 15, 6), 15); }

TEST_F(HostileStation, AFrameThatDoesNotFitTheExerciseIsNotDrawn) {
    core::Snapshot good = core::view(*m_world, core::startState(*m_world, 3));
    EXPECT_TRUE(fits(good, *m_world));
    const auto fitsWith = [&](auto change) {
        core::Snapshot s = good;
        change(s);
        return fits(s, *m_world);
    };
    EXPECT_FALSE(fitsWith([](auto& s) { s.ships.clear(); }));
    EXPECT_FALSE(fitsWith([](auto& s) { s.ships.push_back(s.ships[0]); }));
    EXPECT_FALSE(fitsWith([](auto& s) { s.ships[0].shafts_rps.clear(); }));
    EXPECT_FALSE(fitsWith([](auto& s) { s.ships[0].anchors.clear(); }));
    EXPECT_FALSE(fitsWith([](auto& s) { s.ships[0].lines.push_back({}); }));
    EXPECT_FALSE(fitsWith([](auto& s) { s.targets.push_back({}), s.targets.back().index = 99; }));
    EXPECT_TRUE(fitsWith([&](auto& s) {
        s.added.resize(1);
        s.targets.push_back({});
        s.targets.back().index = m_world->targets.size();
    }));
}

}  // namespace
}  // namespace sagara::wall
