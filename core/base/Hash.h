#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sagara::core {

/// FNV-1a, 64 bits (Fowler, Noll, Vo; RFC draft eastlake-fnv). Names content and detects damage: every step
/// is invertible, so one changed byte always changes the sum. Not for secrets.
class Hash64 {
public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte b : bytes)
            m_value = (m_value ^ static_cast<std::uint64_t>(b)) * 0x00000100000001b3ULL;
    }
    std::uint64_t value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325ULL;
};

inline std::uint64_t hashOf(std::span<const std::byte> bytes) {
    Hash64 hash;
    hash.add(bytes);
    return hash.value();
}
inline std::uint64_t hashOf(std::string_view text) { return hashOf(std::as_bytes(std::span(text))); }

/// 16 lower-case hexadecimal digits.
std::string toHex(std::uint64_t value);

}  // namespace sagara::core
