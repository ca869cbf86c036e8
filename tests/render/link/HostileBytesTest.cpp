// Random, truncated, oversized and damaged bytes: always a message or a reason.
#include <gtest/gtest.h>

#include <random>

#include "render/link/Codec.h"
#include "render/link/PacketReader.h"
#include "tests/render/support/Samples.h"

namespace sagara::link {
namespace {

constexpr KindSet kAll{Kind::Greeting, Kind::Hello, Kind::Refused,  Kind::Welcome, Kind::Setup,
                       Kind::Ready,    Kind::Frame, Kind::Rendered, Kind::Show,    Kind::Shown,
                       Kind::Ping,     Kind::Pong,  Kind::Picture,  Kind::Bye};

/// Reads a whole stream. A message that is accepted must also survive being sent on.
struct Tally {
    int accepted = 0;
    int refused = 0;
    void read(std::span<const std::byte> bytes) {
        PacketReader reader(kAll);
        while (!bytes.empty()) {
            const auto packet = reader.take(bytes);
            if (!packet) return note(packet.error());
            if (!*packet) return;
            const auto message = decode((*packet)->kind, (*packet)->payload);
            if (!message) return note(message.error());
            ++accepted;
            const core::Bytes again = encode(*message);
            const auto back = decode((*packet)->kind, std::span(again).subspan(kHeader_bytes));
            ASSERT_TRUE(back) << back.error().reason;
        }
    }
    void note(const DecodeError& error) {
        EXPECT_FALSE(error.reason.empty());
        ++refused;
    }
};

class HostileBytes : public ::testing::Test {
protected:
    std::mt19937_64 m_random{20261122};
    std::vector<core::Bytes> m_packets;
    Tally m_tally;

    void SetUp() override {
        for (const Message& message : test::oneOfEach()) m_packets.push_back(encode(message));
    }
    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(m_random() % limit); }
    core::Bytes& anyPacket() { return m_packets[below(m_packets.size())]; }
};

TEST_F(HostileBytes, RandomBytes) {
    for (int i = 0; i < 10'000; ++i) {
        core::Bytes bytes(below(400));
        for (std::byte& b : bytes) b = static_cast<std::byte>(m_random());
        m_tally.read(bytes);
    }
    EXPECT_EQ(m_tally.accepted, 0);
}

TEST_F(HostileBytes, RandomPayloadsUnderTrueHeaders) {
    for (int i = 0; i < 10'000; ++i) {
        const auto kind = static_cast<Kind>(1 + below(kLastKind));
        core::Bytes payload(below(300));
        for (std::byte& b : payload) b = static_cast<std::byte>(m_random());
        const auto header =
            encodeHeader({kProtocolVersion, kind, static_cast<std::uint32_t>(payload.size())});
        core::Bytes bytes(header.begin(), header.end());
        bytes.insert(bytes.end(), payload.begin(), payload.end());
        m_tally.read(bytes);
    }
    EXPECT_GT(m_tally.refused, 8000);
}

TEST_F(HostileBytes, EveryTruncation) {
    for (const core::Bytes& packet : m_packets) {
        for (std::size_t length = 0; length < packet.size(); ++length) {
            // Cut on the way: nothing comes of it. Cut before it was sent: a reason, or a shorter message.
            Tally cut;
            cut.read(std::span(packet).first(length));
            EXPECT_EQ(cut.accepted, 0);
            if (length < kHeader_bytes) continue;
            core::Bytes shorter(packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(length));
            const auto payload_bytes = static_cast<std::uint32_t>(length - kHeader_bytes);
            std::memcpy(shorter.data() + 8, &payload_bytes, sizeof payload_bytes);
            m_tally.read(shorter);
        }
    }
    EXPECT_GT(m_tally.refused, 500);
}

TEST_F(HostileBytes, FlippedBits) {
    for (int i = 0; i < 10'000; ++i) {
        core::Bytes bytes = anyPacket();
        for (std::size_t flips = 1 + below(4); flips > 0; --flips)
            bytes[below(bytes.size())] ^= static_cast<std::byte>(1u << below(8));
        m_tally.read(bytes);
    }
    EXPECT_GT(m_tally.refused, 1000);
}

TEST_F(HostileBytes, OversizedLengthsCostNoMemory) {
    for (int i = 0; i < 10'000; ++i) {
        core::Bytes bytes = anyPacket();
        const auto length = static_cast<std::uint32_t>(m_random() | 0x08000000u);
        std::memcpy(bytes.data() + 8, &length, sizeof length);
        m_tally.read(bytes);
    }
    EXPECT_EQ(m_tally.refused, 10'000);
}

TEST_F(HostileBytes, SplicedPackets) {
    for (int i = 0; i < 10'000; ++i) {
        core::Bytes bytes = anyPacket();
        const core::Bytes& other = anyPacket();
        bytes.resize(below(bytes.size()));
        bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(below(other.size())),
                     other.end());
        m_tally.read(bytes);
    }
}

}  // namespace
}  // namespace sagara::link
