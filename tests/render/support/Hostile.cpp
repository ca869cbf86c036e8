#include "tests/render/support/Hostile.h"

#include "render/link/Codec.h"
#include "tests/render/support/Samples.h"

namespace sagara::test {

HostileBytes::HostileBytes(std::uint64_t seed) : m_random(seed) {
    for (const link::Message& message : oneOfEach()) m_packets.push_back(link::encode(message));
}

core::Bytes HostileBytes::random(std::size_t atMost) {
    core::Bytes bytes(below(atMost));
    for (std::byte& b : bytes) b = static_cast<std::byte>(m_random());
    return bytes;
}

core::Bytes HostileBytes::next() {
    core::Bytes bytes = anyPacket();
    switch (below(5)) {
        case 0:
            return random(400);
        case 1:
            bytes.resize(below(bytes.size()));
            return bytes;
        case 2:
            for (std::size_t flips = 1 + below(4); flips > 0; --flips)
                bytes[below(bytes.size())] ^= static_cast<std::byte>(1u << below(8));
            return bytes;
        case 3: {
            const auto length = static_cast<std::uint32_t>(m_random());
            std::memcpy(bytes.data() + 8, &length, sizeof length);
            return bytes;
        }
        default: {
            const core::Bytes& other = anyPacket();
            bytes.resize(below(bytes.size()));
            bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(below(other.size())),
                         other.end());
            return bytes;
        }
    }
}

}  // namespace sagara::test
