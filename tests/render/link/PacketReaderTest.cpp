#include "render/link/PacketReader.h"

#include <gtest/gtest.h>

#include "render/link/Codec.h"
#include "tests/render/support/Samples.h"

namespace sagara::link {
namespace {

constexpr KindSet kAll{Kind::Greeting, Kind::Hello, Kind::Refused,  Kind::Welcome, Kind::Setup,
                       Kind::Ready,    Kind::Frame, Kind::Rendered, Kind::Show,    Kind::Shown,
                       Kind::Ping,     Kind::Pong,  Kind::Picture,  Kind::Bye};

core::Bytes headerOf(std::uint16_t version, std::uint16_t kind, std::uint32_t length) {
    const auto bytes = encodeHeader({version, static_cast<Kind>(kind), length});
    return {bytes.begin(), bytes.end()};
}
DecodeError refusalOf(const core::Bytes& bytes, KindSet expected = kAll) {
    PacketReader reader(expected);
    std::span<const std::byte> rest(bytes);
    const auto result = reader.take(rest);
    return result ? DecodeError{"accepted"} : result.error();
}

TEST(PacketReader, AStreamInAnyPortionsGivesTheSamePackets) {
    core::Bytes stream;
    const auto messages = test::oneOfEach();
    for (const Message& message : messages) {
        const core::Bytes packet = encode(message);
        stream.insert(stream.end(), packet.begin(), packet.end());
    }
    for (const std::size_t portion : {std::size_t{1}, std::size_t{7}, std::size_t{64}, stream.size()}) {
        PacketReader reader(kAll);
        core::Bytes again;
        for (std::size_t at = 0; at < stream.size(); at += portion) {
            auto rest = std::span<const std::byte>(stream).subspan(at, std::min(portion, stream.size() - at));
            while (!rest.empty()) {
                auto packet = reader.take(rest);
                ASSERT_TRUE(packet);
                if (!*packet) continue;
                const auto message = decode((*packet)->kind, (*packet)->payload);
                ASSERT_TRUE(message);
                const core::Bytes bytes = encode(*message);
                again.insert(again.end(), bytes.begin(), bytes.end());
            }
        }
        EXPECT_EQ(again, stream) << portion;
    }
}

TEST(PacketReader, OtherBytesAreRefusedAtOnce) {
    EXPECT_EQ(refusalOf(core::Bytes(12, std::byte{'G'})).reason, "these are not bytes of a Sagara link");
}

TEST(PacketReader, AnotherVersionIsRefusedWithTheOneThatIsSpoken) {
    const DecodeError error = refusalOf(headerOf(9, 2, 10));
    EXPECT_EQ(error.reason, "protocol version 9 is not spoken here, but " + std::to_string(kProtocolVersion));
    EXPECT_TRUE(error.otherVersion);
}

TEST(PacketReader, ARefusalOfAnotherVersionIsStillUnderstood) {
    core::Bytes packet = encode(Refused{"too old", {3, 4}});
    packet[4] = std::byte{4};
    PacketReader reader({Kind::Refused});
    std::span<const std::byte> rest(packet);
    const auto taken = reader.take(rest);
    ASSERT_TRUE(taken && *taken);
    const auto message = decode((*taken)->kind, (*taken)->payload);
    ASSERT_TRUE(message);
    EXPECT_EQ(std::get<Refused>(*message).speaks, (std::vector<std::uint32_t>{3, 4}));
}

TEST(PacketReader, LengthKindAndOrderAreCheckedOnTheHeaderAlone) {
    EXPECT_EQ(refusalOf(headerOf(kProtocolVersion, 99, 0)).reason, "message kind 99 is unknown");
    EXPECT_EQ(refusalOf(headerOf(kProtocolVersion, 0, 0)).reason, "message kind 0 is unknown");
    EXPECT_EQ(refusalOf(headerOf(kProtocolVersion, 7, 0xffffffff)).reason,
              "Frame of 4294967295 bytes, at most 262144 are accepted");
    EXPECT_EQ(refusalOf(headerOf(kProtocolVersion, 5, 100), {Kind::Hello}).reason,
              "Setup is not expected now");
}

}  // namespace
}  // namespace sagara::link
