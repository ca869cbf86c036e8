#include "render/link/Handshake.h"

#include <gtest/gtest.h>

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>

#include "render/link/Codec.h"
#include "render/link/Token.h"
#include "tests/render/support/Aside.h"
#include "tests/render/support/Samples.h"

namespace sagara::link {
namespace {

constexpr int kPatience_ms = 20'000;  // reached only when something is broken

/// A station that takes one connection and does as the test says; the channel runs in a thread.
class Handshake : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(m_server.listen(QHostAddress::LocalHost)); }

    std::unique_ptr<Connection> accept() {
        EXPECT_TRUE(m_server.waitForNewConnection(kPatience_ms));
        return std::make_unique<Connection>(std::unique_ptr<QTcpSocket>(m_server.nextPendingConnection()),
                                            kBeforeHello);
    }
    /// What the channel gets to know: the name it is given, or the error.
    template <typename Station>
    std::string outcome(const Introduction& who, Station&& station) {
        std::string result;
        test::Aside channel([&, port = m_server.serverPort()] {
            auto connection = Connection::to("127.0.0.1", port, kPatience_ms, kBeforeGreeting);
            if (!connection) return void(result = connection.error());
            const auto view = introduce(**connection, who, kPatience_ms);
            result = view ? "view " + view->name : view.error();
        });
        auto connection = accept();
        station(*connection);
        channel.wait();
        return result;
    }
    QTcpServer m_server;
};

void answerHello(Connection& c, const std::string& token) {
    const Greeting hi = greeting();
    c.send(hi);
    const auto hello = c.wait(kPatience_ms);
    ASSERT_TRUE(hello);
    const auto objection = objectionTo(std::get<Hello>(hello->message), hi.nonce, token);
    if (objection) {
        c.send(Refused{*objection, {}});
    } else {
        ChannelView view;
        view.name = std::get<Hello>(hello->message).channel;
        c.send(Welcome{view});
    }
}

TEST_F(Handshake, AChannelThatKnowsTheTokenIsWelcomed) {
    EXPECT_EQ(
        outcome({Role::View, "left", "open sesame"}, [](Connection& c) { answerHello(c, "open sesame"); }),
        "view left");
}

TEST_F(Handshake, AWrongTokenIsRefused) {
    EXPECT_EQ(outcome({Role::View, "left", "guess"}, [](Connection& c) { answerHello(c, "open sesame"); }),
              "the station refuses: the token is wrong");
}

TEST_F(Handshake, AProofFitsOneGreetingAndOneChannel) {
    const Nonce a = freshNonce(), b = freshNonce();
    EXPECT_NE(a, b);
    EXPECT_TRUE(same(proofOf("t", a, "left"), proofOf("t", a, "left")));
    EXPECT_FALSE(same(proofOf("t", a, "left"), proofOf("t", b, "left")));
    EXPECT_FALSE(same(proofOf("t", a, "left"), proofOf("t", a, "right")));
}

TEST_F(Handshake, ConsolesAreRefusedForNow) {
    EXPECT_EQ(outcome({Role::Console, "helm", ""}, [](Connection& c) { answerHello(c, ""); }),
              "the station refuses: this station takes no consoles yet");
}

TEST_F(Handshake, AStationOfAnotherVersionIsNamedToThePerson) {
    EXPECT_EQ(outcome({Role::View, "left", ""},
                      [](Connection& c) {
                          Greeting hi = greeting();
                          hi.speaks = {8, 9};
                          core::Bytes packet = encode(hi);
                          packet[4] = std::byte{9};
                          c.sendPacket(packet);
                          c.wait(kPatience_ms);
                      }),
              "the station speaks protocol version 8, 9, this program " + std::to_string(kProtocolVersion));
}

TEST_F(Handshake, AnOlderChannelHearsWhatIsSpoken) {
    std::string told;
    std::vector<std::uint32_t> speaks;
    test::Aside channel([&, port = m_server.serverPort()] {
        auto connection = Connection::to("127.0.0.1", port, kPatience_ms, {Kind::Refused});
        ASSERT_TRUE(connection);
        core::Bytes packet = encode(Hello{});
        packet[4] = std::byte{0};
        (*connection)->sendPacket(packet);
        const auto answer = (*connection)->wait(kPatience_ms);
        ASSERT_TRUE(answer);
        told = std::get<Refused>(answer->message).reason;
        speaks = std::get<Refused>(answer->message).speaks;
    });
    auto connection = accept();
    EXPECT_FALSE(connection->wait(kPatience_ms));
    EXPECT_FALSE(connection->isOpen());
    channel.wait();
    EXPECT_EQ(told, "protocol version 0 is not spoken here, but " + std::to_string(kProtocolVersion));
    EXPECT_EQ(speaks, std::vector<std::uint32_t>{kProtocolVersion});
}

TEST_F(Handshake, AStationThatIsSilentOrGoneIsReported) {
    EXPECT_EQ(outcome({}, [](Connection& c) { c.close("enough"); }),
              "the connection was closed by the other side");
    const auto nobody = Connection::to("127.0.0.1", 1, 2000, kBeforeGreeting);
    ASSERT_FALSE(nobody);
    EXPECT_EQ(nobody.error(), "cannot reach 127.0.0.1:1: Connection refused");
}

TEST_F(Handshake, MessagesComeInOrderAndWhole) {
    core::Bytes got, sent;
    for (const Message& message : test::oneOfEach()) {
        const core::Bytes packet = encode(message);
        sent.insert(sent.end(), packet.begin(), packet.end());
    }
    // As one who hears everything, whatever the phase.
    constexpr KindSet all{Kind::Greeting, Kind::Hello, Kind::Refused,  Kind::Welcome, Kind::Setup,
                          Kind::Ready,    Kind::Frame, Kind::Rendered, Kind::Show,    Kind::Shown,
                          Kind::Ping,     Kind::Pong,  Kind::Picture,  Kind::Bye};
    test::Aside channel([&, port = m_server.serverPort()] {
        auto connection = Connection::to("127.0.0.1", port, kPatience_ms, all);
        ASSERT_TRUE(connection);
        for (int i = 0; i < int{kLastKind}; ++i) {
            const auto received = (*connection)->wait(kPatience_ms);
            ASSERT_TRUE(received) << i;
            const core::Bytes packet = encode(received->message);
            got.insert(got.end(), packet.begin(), packet.end());
        }
    });
    auto connection = accept();
    for (std::size_t at = 0; at < sent.size(); at += 100) {
        connection->sendPacket({sent.begin() + static_cast<std::ptrdiff_t>(at),
                                sent.begin() + static_cast<std::ptrdiff_t>(std::min(at + 100, sent.size()))});
    }
    while (!channel.finished()) (void)connection->wait(1);
    channel.wait();
    EXPECT_EQ(got, sent);
}

}  // namespace
}  // namespace sagara::link
