#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "render/link/DecodeError.h"

/// The envelope every message travels in: who speaks what, and how much of it may come.
namespace sagara::link {

/// The version spoken here. It grows when an old receiver would misunderstand; a new field alone does not.
inline constexpr std::uint16_t kProtocolVersion = 2;

/// Values on the wire; never reused.
enum class Kind : std::uint16_t {
    Greeting = 1,
    Hello = 2,
    Refused = 3,
    Welcome = 4,
    Setup = 5,
    Ready = 6,
    Frame = 7,
    Rendered = 8,
    Show = 9,
    Shown = 10,
    Ping = 11,
    Pong = 12,
    Picture = 13,
    Bye = 14
};
inline constexpr std::uint16_t kLastKind = 14;
const char* kindName(Kind kind);

/// Longest payload of a kind. Checked before anything is allocated.
std::size_t mostPayload_bytes(Kind kind);
/// Most fields at the top level of a kind's payload: a payload of empty list entries would grow fifty-fold in
/// memory.
std::size_t mostFields(Kind kind);

/// A set of kinds: what a side is ready to hear at this point of the talk.
class KindSet {
public:
    constexpr KindSet(std::initializer_list<Kind> kinds) {
        for (const Kind kind : kinds) m_bits |= bit(kind);
    }
    constexpr bool has(Kind kind) const { return (m_bits & bit(kind)) != 0; }

private:
    static constexpr std::uint32_t bit(Kind kind) { return 1u << static_cast<unsigned>(kind); }
    std::uint32_t m_bits = 0;
};

/// Twelve bytes before every payload: "SGRL", version, kind, length; little-endian. Frozen for every version
/// to come.
struct Header {
    std::uint16_t version = kProtocolVersion;
    Kind kind = Kind::Bye;
    std::uint32_t payload_bytes = 0;
};
inline constexpr std::size_t kHeader_bytes = 12;

std::array<std::byte, kHeader_bytes> encodeHeader(const Header& header);
/// Refuses what is not ours, another version, an unknown kind, one not expected now, and too much of it.
core::Result<Header, DecodeError> decodeHeader(std::span<const std::byte, kHeader_bytes> bytes,
                                               KindSet expected);

}  // namespace sagara::link
