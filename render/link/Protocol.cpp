#include "render/link/Protocol.h"

#include <bit>
#include <cstring>
#include <string>

namespace sagara::link {
namespace {

static_assert(std::endian::native == std::endian::little, "headers are written as native bytes");

constexpr std::array<char, 4> kMagic{'S', 'G', 'R', 'L'};

struct Limits {
    const char* name;
    std::size_t payload_bytes;
    std::size_t fields;
};
constexpr std::size_t kKiB = 1024, kMiB = 1024 * 1024;
/// By kind. Setup: an area document of a large harbour has some 10 MB. Picture: 4096 x 4096.
constexpr std::array<Limits, kLastKind + 1> kLimits{{
    {"nothing", 0, 0},
    {"Greeting", kKiB, 16},
    {"Hello", kKiB, 8},
    {"Refused", 4 * kKiB, 16},
    {"Welcome", kKiB, 4},
    {"Setup", 48 * kMiB, 64},
    {"Ready", 16, 4},
    {"Frame", 256 * kKiB, 1024},
    {"Rendered", 32, 4},
    {"Show", 32, 4},
    {"Shown", 32, 4},
    {"Ping", 64, 8},
    {"Pong", 64, 8},
    {"Picture", 64 * kMiB + 64, 8},
    {"Bye", 4 * kKiB, 4},
}};

const Limits& limitsOf(Kind kind) { return kLimits[static_cast<std::size_t>(kind)]; }

template <typename T>
T readAt(std::span<const std::byte, kHeader_bytes> bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

}  // namespace

const char* kindName(Kind kind) { return limitsOf(kind).name; }
std::size_t mostPayload_bytes(Kind kind) { return limitsOf(kind).payload_bytes; }
std::size_t mostFields(Kind kind) { return limitsOf(kind).fields; }

std::array<std::byte, kHeader_bytes> encodeHeader(const Header& header) {
    std::array<std::byte, kHeader_bytes> bytes;
    std::memcpy(bytes.data(), kMagic.data(), 4);
    std::memcpy(bytes.data() + 4, &header.version, 2);
    std::memcpy(bytes.data() + 6, &header.kind, 2);
    std::memcpy(bytes.data() + 8, &header.payload_bytes, 4);
    return bytes;
}

core::Result<Header, DecodeError> decodeHeader(std::span<const std::byte, kHeader_bytes> bytes,
                                               KindSet expected) {
    if (std::memcmp(bytes.data(), kMagic.data(), 4) != 0)
        return DecodeError{"these are not bytes of a Sagara link"};
    const auto version = readAt<std::uint16_t>(bytes, 4), number = readAt<std::uint16_t>(bytes, 6);
    const auto length = readAt<std::uint32_t>(bytes, 8);
    const bool known = number >= 1 && number <= kLastKind;
    const Kind kind = static_cast<Kind>(known ? number : 0);
    // Greeting and Refused keep their layout for ever, so that two versions can tell each other what they
    // speak.
    const bool frozen = kind == Kind::Greeting || kind == Kind::Refused;
    if (version != kProtocolVersion && !frozen)
        return DecodeError{"protocol version " + std::to_string(version) + " is not spoken here, but " +
                               std::to_string(kProtocolVersion),
                           true};
    if (!known) return DecodeError{"message kind " + std::to_string(number) + " is unknown"};
    if (!expected.has(kind)) return DecodeError{std::string(kindName(kind)) + " is not expected now"};
    if (length > mostPayload_bytes(kind))
        return DecodeError{std::string(kindName(kind)) + " of " + std::to_string(length) +
                           " bytes, at most " + std::to_string(mostPayload_bytes(kind)) + " are accepted"};
    return Header{version, kind, length};
}

}  // namespace sagara::link
