#include "render/link/Codec.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/exercise/State.h"
#include "tests/render/support/Samples.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::link {
namespace {

Kind kindOf(const core::Bytes& packet) {
    std::uint16_t kind;
    std::memcpy(&kind, packet.data() + 6, sizeof kind);
    return static_cast<Kind>(kind);
}
core::Result<Message, DecodeError> decodePacket(const core::Bytes& packet) {
    return decode(kindOf(packet), std::span(packet).subspan(kHeader_bytes));
}
std::string reasonFor(const Message& message) {
    const auto decoded = decodePacket(encode(message));
    return decoded ? "" : decoded.error().reason;
}

TEST(Codec, EveryKindComesBackAsItWasSent) {
    const auto messages = test::oneOfEach();
    EXPECT_EQ(messages.size(), std::size_t{kLastKind}) << "a kind has no sample";
    for (const Message& message : messages) {
        const core::Bytes packet = encode(message);
        const auto back = decodePacket(packet);
        ASSERT_TRUE(back) << kindName(kindOf(packet)) << ": " << back.error().reason;
        EXPECT_EQ(back->index(), message.index());
        EXPECT_EQ(encode(*back), packet) << kindName(kindOf(packet));
    }
}

TEST(Codec, AFrameKeepsEveryNumberToTheBit) {
    const Frame frame{12, {10'013'337}, test::busySnapshot()};
    const auto back = decodePacket(encode(frame));
    ASSERT_TRUE(back);
    const Frame& f = std::get<Frame>(*back);
    EXPECT_EQ(f.number, 12u);
    EXPECT_EQ(f.time.us, 10'013'337);
    EXPECT_EQ(f.snapshot.tick, frame.snapshot.tick);
    const core::ShipMotion &m = f.snapshot.ships[0].motion, &sent = frame.snapshot.ships[0].motion;
    EXPECT_EQ(std::memcmp(&m, &sent, sizeof m), 0);
    EXPECT_EQ(f.snapshot.ships[0].lines[1].status, core::LineStatus::Parted);
    EXPECT_EQ(f.snapshot.ships[0].anchors[0].position, frame.snapshot.ships[0].anchors[0].position);
    EXPECT_EQ(f.snapshot.ships[0].lines[0].length_m, 31.5);
    EXPECT_EQ(f.snapshot.ships[0].anchors[0].cableOut_m, 82.3);
    EXPECT_TRUE(f.snapshot.ships[0].notUnderCommand);
    EXPECT_EQ(f.snapshot.targets[0].activity, core::Activity::Trawling);
    EXPECT_EQ(f.snapshot.targets[1].activity, core::Activity::UnderWay);
    EXPECT_EQ(f.snapshot.targets[1].index, 5u);
    EXPECT_EQ(f.snapshot.targets[0].roll_rad, 0.02);
    EXPECT_EQ(f.snapshot.added, frame.snapshot.added);
    EXPECT_EQ(f.snapshot.weather.swells, frame.snapshot.weather.swells);
    EXPECT_EQ(f.snapshot.weather.wind, frame.snapshot.weather.wind);
    EXPECT_EQ(f.snapshot.weather.exposure, core::Exposure::Ocean);
    EXPECT_EQ(f.snapshot.sea.systems, frame.snapshot.sea.systems);
    EXPECT_EQ(f.snapshot.tide_m, 0.42);
}

TEST(Codec, AChannelRaisesTheSameSeaToTheBit) {
    const auto world = test::lessonWorld();
    const core::State state = core::startState(*world, 4);
    const core::Snapshot sent = core::view(*world, state);
    ASSERT_FALSE(sent.sea.active.empty());

    const auto setup = decodePacket(encode(link::Setup{world->documents, world->seed}));
    ASSERT_TRUE(setup);
    const auto there =
        core::buildWorld(std::get<link::Setup>(*setup).documents, std::get<link::Setup>(*setup).seed);
    ASSERT_TRUE(there);
    const auto frame = decodePacket(encode(Frame{1, sent.time(), sent}));
    ASSERT_TRUE(frame);
    core::SeaState sea = std::get<Frame>(*frame).snapshot.sea;
    core::raiseSea((*there)->waves, sea);
    EXPECT_EQ(sea.active, sent.sea.active);
    EXPECT_EQ(sea.amplitude_m, sent.sea.amplitude_m);
}

TEST(Codec, NumbersThatAreNoneOrBeyondReasonAreRefusedByName) {
    const auto frameWith = [](auto change) {
        Frame frame{1, {0}, test::busySnapshot()};
        change(frame.snapshot);
        return reasonFor(frame);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(frameWith([&](auto& s) { s.ships[0].motion.pitch_rad = nan; }), "Frame: ship.pitch_rad is nan");
    EXPECT_EQ(frameWith([&](auto& s) { s.targets[1].position.north_m = -inf; }),
              "Frame: target.position_m is -inf");
    EXPECT_EQ(frameWith([&](auto& s) { s.tide_m = inf; }), "Frame: tide_m is inf");
    EXPECT_EQ(frameWith([&](auto& s) { s.sea.systems[0].peakPeriod_s = 0.0; }),
              "Frame: sea.peakPeriod_s is 0.000000");
    EXPECT_EQ(frameWith([&](auto& s) { s.weather.rain = 1.5; }), "Frame: weather.rain is 1.500000");
    EXPECT_EQ(frameWith([&](auto& s) { s.targets[0].activity = static_cast<core::Activity>(9); }),
              "Frame: target.activity is 9");
    EXPECT_EQ(frameWith([&](auto& s) { s.ships[0].lines[0].length_m = 10'001.0; }),
              "Frame: line.length_m is 10001.000000");
    EXPECT_EQ(frameWith([&](auto& s) { s.ships[0].lines[0].length_m = -1.0; }),
              "Frame: line.length_m is -1.000000");
    EXPECT_EQ(frameWith([&](auto& s) { s.ships[0].anchors[0].cableOut_m = nan; }),
              "Frame: anchor.cableOut_m is nan");
    EXPECT_EQ(frameWith([&](auto& s) { s.added[0].length_m = nan; }), "Frame: added.length_m is nan");
    EXPECT_EQ(frameWith([&](auto& s) { s.added[0].type = static_cast<core::TargetType>(99); }),
              "Frame: added.type is 99");
    EXPECT_EQ(frameWith([&](auto& s) { s.level = 9; }), "Frame: level is 9");
    EXPECT_EQ(reasonFor(Frame{1, {std::numeric_limits<std::int64_t>::min()}, test::busySnapshot()}),
              "Frame: the time is beyond all exercises");
    EXPECT_EQ(reasonFor(Pong{1, std::numeric_limits<std::int64_t>::max(), 0, 0}),
              "Pong: a clock shows 9223372036854775807 us");
}

TEST(Codec, ListsTooLongAreRefused) {
    Frame frame{1, {0}, test::busySnapshot()};
    frame.snapshot.targets.assign(513, {});
    EXPECT_EQ(reasonFor(frame), "Frame: 513 targets, at most 512 are accepted");
    frame.snapshot.targets.clear();
    frame.snapshot.added.assign(33, frame.snapshot.added[0]);
    EXPECT_EQ(reasonFor(frame), "Frame: 33 added targets, at most 32 are accepted");
    frame.snapshot.added.clear();
    frame.snapshot.ships[0].lines.assign(9, {});
    EXPECT_EQ(reasonFor(frame), "Frame: 9 lines, at most 8 are accepted");
    // 60 000 empty entries: counted before a list is made of them.
    core::Bytes entries;
    for (int i = 0; i < 60'000; ++i) entries.insert(entries.end(), {std::byte{0x32}, std::byte{0}});
    const auto refused = decode(Kind::Frame, entries);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().reason, "Frame: too much of it");
}

TEST(Codec, TextForPeopleHasNoControlCharacters) {
    const auto bye = decodePacket(encode(Bye{"a\x1b[2Jb\n\xc3\xa9"}));
    ASSERT_TRUE(bye);
    EXPECT_EQ(std::get<Bye>(*bye).reason, "a [2Jb \xc3\xa9");
    EXPECT_EQ(reasonFor(Hello{Role::View, std::string(201, 'x'), {}, "", 0}), "Hello: channel of 201 bytes");
}

TEST(Codec, APictureMustHaveItsPixels) {
    EXPECT_EQ(reasonFor(Picture{1, 4, 2, std::vector<std::byte>(31)}), "Picture: a picture of 31 bytes");
    EXPECT_EQ(reasonFor(Picture{1, 100'000, 2, {}}), "Picture: width_px is 100000");
}

TEST(Codec, AnEmptyFrustumIsRefused) {
    Welcome welcome;
    welcome.view.frustum = {-0.5, 0.5, 0.3, 0.3};
    EXPECT_EQ(reasonFor(welcome), "Welcome: the frustum is empty");
}

}  // namespace
}  // namespace sagara::link
