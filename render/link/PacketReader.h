#pragma once

#include <optional>
#include <span>

#include "core/base/Archive.h"
#include "render/link/Protocol.h"

namespace sagara::link {

/// A message cut out of a stream, still encoded.
struct Packet {
    Kind kind = Kind::Bye;
    core::Bytes payload;
};

/// Cuts a stream of bytes into packets. Takes any bytes in any portions; memory grows only with bytes that
/// came, up to one packet of an expected kind. After a refusal the stream is lost: close it.
class PacketReader {
public:
    explicit PacketReader(KindSet expected) : m_expected(expected) {}

    /// What may come from now on. A header already read stays accepted.
    void expect(KindSet expected) { m_expected = expected; }

    /// Takes bytes from the front of `bytes`, at most to the end of one packet, and drops them there. A
    /// packet when one is whole; nothing when more bytes are needed.
    core::Result<std::optional<Packet>, DecodeError> take(std::span<const std::byte>& bytes);

private:
    bool fill(core::Bytes& to, std::size_t wanted, std::span<const std::byte>& from);

    KindSet m_expected;
    core::Bytes m_head;
    std::optional<Header> m_header;
    core::Bytes m_payload;
};

}  // namespace sagara::link
