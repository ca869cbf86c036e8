#pragma once

#include <random>

#include "core/base/Archive.h"

namespace sagara::test {

/// Bytes a broken or hostile peer may send: random, or a true packet cut, damaged, spliced or with another
/// length. The same for the same seed.
class HostileBytes {
public:
    explicit HostileBytes(std::uint64_t seed);
    core::Bytes next();
    core::Bytes random(std::size_t atMost);

private:
    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(m_random() % limit); }
    core::Bytes& anyPacket() { return m_packets[below(m_packets.size())]; }
    std::mt19937_64 m_random;
    std::vector<core::Bytes> m_packets;
};

}  // namespace sagara::test
