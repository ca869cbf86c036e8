#include "render/link/PacketReader.h"

#include <algorithm>

namespace sagara::link {

bool PacketReader::fill(core::Bytes& to, std::size_t wanted, std::span<const std::byte>& from) {
    const std::size_t count = std::min(wanted - to.size(), from.size());
    to.insert(to.end(), from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
    from = from.subspan(count);
    return to.size() == wanted;
}

core::Result<std::optional<Packet>, DecodeError> PacketReader::take(std::span<const std::byte>& bytes) {
    if (!m_header) {
        if (!fill(m_head, kHeader_bytes, bytes)) return std::optional<Packet>();
        const auto header = decodeHeader(std::span<const std::byte, kHeader_bytes>(m_head), m_expected);
        if (!header) return header.error();
        m_header = *header;
    }
    if (!fill(m_payload, m_header->payload_bytes, bytes)) return std::optional<Packet>();
    Packet packet{m_header->kind, std::move(m_payload)};
    m_head.clear();
    m_header.reset();
    m_payload = {};
    return std::optional(std::move(packet));
}

}  // namespace sagara::link
